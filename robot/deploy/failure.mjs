// The two ways in which a command fails, and how it says so.

/** What the person who called must mend: a sentence with what, where, what was expected and what came. Exit status 2. */
export class BadInput extends Error {}

/** What a robot could not do, one sentence. The others go on. Exit status 1. */
export class RobotFailed extends Error {}

/** Runs `main`, which answers with an exit status, and ends this process with it. */
export async function runMain(command, main) {
  try {
    process.exitCode = await main(process.argv.slice(2));
  } catch (error) {
    if (!(error instanceof BadInput || error instanceof RobotFailed)) throw error;
    console.error(`${command}: ${error.message}`);
    process.exitCode = error instanceof BadInput ? 2 : 1;
  }
}
