// The state of a page's own playhead when its connection or the page ended, so that the next one goes on from there.

export interface Left {
  play: boolean;
  speed: number;
  at_ns: bigint;
  /** The span [ns] and the name of the recording. Another recording begins at its begin. */
  start_ns: bigint;
  end_ns: bigint;
  session: string;
}

/** Returns the text that leftIn() reads. */
export const textOfLeft = ({ play, speed, at_ns, start_ns, end_ns, session }: Left): string =>
  [play ? "plays" : "stands", speed, at_ns, start_ns, end_ns, session].join(" ");

/** Returns the state in a kept text, or undefined if it is none. */
export function leftIn(text: string): Left | undefined {
  const match = /^(plays|stands) ([\d.e+-]+) (\d{1,20}) (\d{1,20}) (\d{1,20}) (.*)$/.exec(text);
  if (!match || !(Number(match[2]) > 0)) return undefined;
  const [at_ns, start_ns, end_ns] = match.slice(3, 6).map(BigInt) as [bigint, bigint, bigint];
  return { play: match[1] === "plays", speed: Number(match[2]), at_ns, start_ns, end_ns, session: match[6]! };
}
