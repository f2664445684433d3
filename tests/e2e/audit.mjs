// Judges a page as it is drawn: contrast of texts, names for people who cannot see it, size of targets, and texts that
// are cut off.

/**
 * Returns a sentence for each fault of the page. It runs in the page, so it refers to nothing outside. `finger`: targets
 * must be at least 44 px high.
 */
export function faultsOf({ finger }) {
  const kText = 4.5; // contrast (WCAG 2.1, AA)
  const kLargeText = 3; // of at least 24 px, or 18.66 px in bold
  const kTarget = 44; // [px]
  const faults = new Set();
  const all = [...document.querySelectorAll("body *")].filter((element) =>
    element.checkVisibility({ opacityProperty: true, visibilityProperty: true }),
  );

  const words = (text) => text.trim().replace(/\s+/g, " ").slice(0, 40);
  const nameOf = (element) => {
    const labels = [...(element.labels ?? [])].map((label) => label.textContent).join(" ");
    const by = document.getElementById(element.getAttribute("aria-labelledby") ?? "")?.textContent ?? "";
    return words(
      [element.getAttribute("aria-label"), by, labels, element.textContent, element.title].find((name) =>
        name?.trim(),
      ) ?? "",
    );
  };
  const who = (element) => `${element.tagName.toLowerCase()} “${nameOf(element)}”`;
  const isHidden = (element) => getComputedStyle(element).clipPath !== "none"; // for screen readers only
  const isDisabled = (element) => element.closest(":disabled, label:has(:disabled)") !== null;

  // colours

  const pen = Object.assign(document.createElement("canvas"), { width: 1, height: 1 }).getContext("2d", {
    willReadFrequently: true,
  });
  const known = new Map();
  /** Red, green, blue and opacity, 0 .. 1. */
  function rgba(colour) {
    if (!known.has(colour)) {
      pen.clearRect(0, 0, 1, 1);
      pen.fillStyle = colour;
      pen.fillRect(0, 0, 1, 1);
      known.set(
        colour,
        [...pen.getImageData(0, 0, 1, 1).data].map((value) => value / 255),
      );
    }
    return known.get(colour);
  }
  const over = ([r, g, b, a], ground) => [r, g, b].map((value, i) => a * value + (1 - a) * ground[i]);
  /** The colour behind a text; undefined over a picture. */
  function groundOf(element) {
    const layers = [];
    for (let at = element; at; at = at.parentElement) {
      const colour = rgba(getComputedStyle(at).backgroundColor);
      layers.push(colour);
      if (colour[3] === 1) return layers.reverse().reduce((ground, layer) => over(layer, ground), [0, 0, 0]);
      if (
        ["absolute", "fixed"].includes(getComputedStyle(at).position) &&
        at.parentElement?.querySelector(":scope > canvas")
      )
        return undefined;
    }
    return undefined;
  }
  const brightness = (colour) =>
    colour
      .map((value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4))
      .reduce((sum, value, i) => sum + value * [0.2126, 0.7152, 0.0722][i], 0);
  for (const element of all) {
    const own = [...element.childNodes].some(({ nodeType, data }) => nodeType === Node.TEXT_NODE && data.trim());
    if (!own || isHidden(element) || isDisabled(element)) continue;
    const style = getComputedStyle(element);
    const ground = groundOf(element);
    if (!ground) continue;
    const [a, b] = [brightness(over(rgba(style.color), ground)), brightness(ground)];
    const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    const size = parseFloat(style.fontSize);
    const isLarge = size >= 24 || (size >= 18.66 && Number(style.fontWeight) >= 700);
    if (contrast < (isLarge ? kLargeText : kText))
      faults.add(`${who(element)}: its text has a contrast of ${contrast.toFixed(2)}`);
  }

  // names
  const controls = all.filter((element) =>
    element.matches("a[href], button, select, input, textarea, summary, [role=slider], [role=separator]"),
  );
  for (const element of [...controls, ...all.filter((element) => element.matches("canvas, svg[role=img]"))])
    if (!nameOf(element)) faults.add(`${element.outerHTML.slice(0, 80)}: it has no name`);
  for (const element of all.filter(({ tagName }) => tagName === "CANVAS"))
    if (!element.hasAttribute("role")) faults.add(`${who(element)}: a canvas without a role`);

  // targets
  if (finger)
    for (const element of controls) {
      if (isHidden(element) || element.matches("p a, [role=separator]")) continue;
      const target = element.matches("[type=checkbox], [type=radio]") ? (element.closest("label") ?? element) : element;
      const { height } = target.getBoundingClientRect();
      if (height > 0 && height < kTarget - 0.5)
        faults.add(`${who(element)}: only ${height.toFixed(0)} px high for a finger`);
    }

  // cut off, or out of the screen
  if (document.documentElement.scrollWidth > innerWidth) faults.add("the page scrolls sideways");
  for (const element of all) {
    const style = getComputedStyle(element);
    if (!element.textContent.trim() || isHidden(element) || style.overflowX === "visible") continue;
    if (element.scrollWidth <= element.clientWidth + 1 || ["auto", "scroll"].includes(style.overflowX)) continue;
    if (style.textOverflow !== "ellipsis") faults.add(`${who(element)}: cut off without an ellipsis`);
    else if (!element.closest("[title]")) faults.add(`${who(element)}: cut off, and no title has the whole text`);
  }
  for (const element of controls) {
    if (isHidden(element) || !element.textContent.trim() || element.matches("select")) continue;
    if (element.scrollWidth > element.clientWidth + 1 && getComputedStyle(element).overflowX === "visible")
      faults.add(`${who(element)}: its text is wider than it is`);
  }
  return [...faults];
}

/** Returns a sentence for each control that looks the same with the keyboard's focus as without. Runs in the page. */
export function unmarkedFocus() {
  const look = (element) =>
    ["", "::before", "::after"]
      .map((part) => getComputedStyle(element, part || undefined))
      .map((style) => [style.outline, style.boxShadow, style.backgroundColor, style.borderColor].join())
      .join() + (element.parentElement ? getComputedStyle(element.parentElement).outline : "");
  const controls = [
    ...document.querySelectorAll("a[href], button, select, input, textarea, summary, [tabindex='0']"),
  ].filter((element) => element.checkVisibility() && !element.disabled);
  const faults = new Set();
  for (const element of controls) {
    document.activeElement?.blur();
    const before = look(element);
    element.focus({ focusVisible: true, preventScroll: true });
    if (document.activeElement === element && look(element) === before) faults.add(element.outerHTML.slice(0, 100));
  }
  document.activeElement?.blur();
  return [...faults];
}
