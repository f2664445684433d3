import { expect, test } from "vitest";
import { contrast, wordsOn } from "./contrast";
import { kEditColour, kHeatColour } from "./foreseen";
import { kOverlayColours } from "./overlay";
import { kSkillColours } from "./phases";
import { kLineStyles } from "./plot";
import { kLiveries, liveriesOf } from "./robot_sign";
import { distance, kSights } from "./test_sight";

/** Returns the two colours of a palette that look most alike in the sight that separates them least. */
function nearest(colours: string[]): { apart: number; who: string } {
  let found = { apart: Infinity, who: "" };
  for (const [name, sight] of Object.entries(kSights))
    colours.forEach((one, i) =>
      colours.slice(i + 1).forEach((other) => {
        const apart = distance(sight, one, other);
        if (apart < found.apart) found = { apart, who: `${one} and ${other}, ${name}` };
      }),
    );
  return found;
}

test("the measure itself: black and white are far apart, and red and green are near for people without red or green cones", () => {
  for (const sight of Object.values(kSights)) expect(distance(sight, "#000000", "#ffffff")).toBeCloseTo(100, 0);
  const [all, protanopia, deuteranopia] = ["all colours", "protanopia", "deuteranopia"].map((name) =>
    distance(kSights[name]!, "#cc6644", "#77994a"),
  );
  expect(all).toBeGreaterThan(55);
  expect(Math.min(protanopia!, deuteranopia!)).toBeLessThan(20);
});

const kThemes = ["dark", "light"] as const;
const kPanels = { dark: "#1a2027", light: "#ffffff" }; // --panel of base.css

test("with every kind of sight and in both themes, lines of a plot with equal dashes differ", () => {
  const dashes = [...new Set(kLineStyles.map(({ dash }) => dash.join()))];
  for (const theme of kThemes)
    for (const dash of dashes) {
      const { apart, who } = nearest(
        kLineStyles.filter((style) => style.dash.join() === dash).map((style) => style[theme]),
      );
      expect(apart, who).toBeGreaterThan(15);
    }
});

test("lines and the words of their axes are readable in both themes, and so are the words on skills", () => {
  for (const theme of kThemes)
    for (const style of kLineStyles) expect(contrast(style[theme], kPanels[theme])).toBeGreaterThan(4.5);
  for (const colour of kSkillColours) expect(contrast(wordsOn(colour), colour)).toBeGreaterThan(4.5);
});

test("with every kind of sight, both teams differ from each other and from the carpet", () => {
  const { apart, who } = nearest([kLiveries.home.colour, kLiveries.away.colour, "#23523a"]);
  expect(apart, who).toBeGreaterThan(35);
});

test("teams differ by brightness and shape too", () => {
  const { home, away } = kLiveries;
  expect(contrast(home.colour, away.colour)).toBeGreaterThan(2);
  expect(contrast(away.colour, "#23523a")).toBeGreaterThan(2);
  expect(home.shape).not.toBe(away.shape);
});

test("jerseys give the sides their colours, unless they are unknown or equal", () => {
  expect(liveriesOf("red", "black")).toMatchObject({
    home: { colour: "#e33b2e", shape: "disc" },
    away: { colour: "#20252b", shape: "square" },
  });
  for (const [home, away] of [
    ["red", "red"],
    ["unspecified", "blue"],
    ["", ""],
  ] as const)
    expect(liveriesOf(home, away)).toEqual(kLiveries);
});

test("with every kind of sight, skills differ, and so do the overlays of pictures", () => {
  const skills = nearest(kSkillColours);
  expect(skills.apart, skills.who).toBeGreaterThan(15);
  const over = nearest([kOverlayColours.ball, kOverlayColours.own, kOverlayColours.robot, kOverlayColours.post]);
  expect(over.apart, over.who).toBeGreaterThan(18);
});

test("with every kind of sight, teams, heat and edits on the What-if field differ", () => {
  const { apart, who } = nearest([kLiveries.home.colour, kLiveries.away.colour, kEditColour, kHeatColour, "#23523a"]);
  expect(apart, who).toBeGreaterThan(20);
});
