// The page's storage in the browser, and the clipboard. A private window may refuse storage; then nothing is stored.

export type Theme = "light" | "dark";

export function kept(storage: "localStorage" | "sessionStorage", key: string): string {
  try {
    return window[storage].getItem(key) ?? "";
  } catch {
    return "";
  }
}

export function keep(storage: "localStorage" | "sessionStorage", key: string, value: string): void {
  try {
    window[storage].setItem(key, value);
  } catch {
    // not stored
  }
}

/** The theme in use: the chosen one, else the system's. */
export function theme(): Theme {
  const chosen = document.documentElement.dataset["theme"];
  if (chosen === "light" || chosen === "dark") return chosen;
  return matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
}

export function chooseTheme(chosen: Theme): void {
  document.documentElement.dataset["theme"] = chosen;
  keep("localStorage", "theme", chosen);
}

export function restoreTheme(): void {
  const chosen = kept("localStorage", "theme");
  if (chosen === "light" || chosen === "dark") chooseTheme(chosen);
}

/** Copies through a selection, because http pages have no clipboard API. Returns false if the browser refuses. */
export function copyText(text: string): boolean {
  const focused = document.activeElement;
  const field = document.createElement("textarea");
  field.value = text;
  field.className = "visually-hidden";
  field.readOnly = true;
  document.body.append(field);
  field.select();
  try {
    return document.execCommand("copy");
  } catch {
    return false;
  } finally {
    field.remove();
    if (focused instanceof HTMLElement) focused.focus();
  }
}
