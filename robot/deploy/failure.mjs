// The two kinds of failure of a command, and their reports.

/** A fault that the user must fix: a sentence with what is wrong, where, what was expected and what came. Exit status 2. */
export class BadInput extends Error {}

/** A failure of one robot, in one sentence. The other robots continue. Exit status 1. */
export class RobotFailed extends Error {}

/** Runs `main`, which returns an exit status, and sets that of this process. */
export async function runMain(command, main) {
  try {
    process.exitCode = await main(process.argv.slice(2));
  } catch (error) {
    if (!(error instanceof BadInput || error instanceof RobotFailed)) throw error;
    console.error(`${command}: ${error.message}`);
    process.exitCode = error instanceof BadInput ? 2 : 1;
  }
}
