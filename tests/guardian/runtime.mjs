// The runtime with the body nao, and a viewer's connection to it.
import { Live } from "../e2e/live.mjs";
import { start, temporaryFolder } from "../e2e/support.mjs";
import { World } from "./world.mjs";

/** A robot, its guardian, and the runtime with a viewer that follows `objects`. */
export async function open(t, objects, ...args) {
  const world = new World(t);
  await world.startRobot();
  await world.startGuardian();
  const live = await join(t, world, objects, ...args);
  return { world, ...live };
}

/** The runtime of a robot whose guardian runs. */
export async function join(t, world, objects, ...args) {
  const folder = temporaryFolder(t);
  const door = `${folder}/door`;
  const server = await start(
    t,
    folder,
    "foresight-robot",
    "--body",
    "nao",
    "--guardian",
    world.link,
    "--door",
    door,
    ...args,
  );
  const live = await Live.open(t, server);
  await live.until(() => live.channels.has("/14/2/joints"), "the channels");
  await live.subscribe(...objects.map((object) => `/14/2/${object}`));
  /** Returns the newest version of an object, decoded, or undefined before the first. */
  const newest = (object) => {
    const message = live.messages.get(`/14/2/${object}`).at(-1);
    return message && live.decoded(`/14/2/${object}`, message);
  };
  return { server, live, newest, door };
}
