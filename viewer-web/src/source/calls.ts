// Pending service calls. Each ends with one answer or with one sentence that says why there is none.

const kTimeoutMs = 10000;

interface Call {
  service: string;
  resolve(answer: unknown): void;
  reject(error: Error): void;
  timer: ReturnType<typeof setTimeout>;
}

export type Answer = Record<string, unknown>;

/** The cause of an error that a service names: "token" if it needs the right token. */
export const causeOf = (error: unknown): string =>
  error instanceof Error && typeof error.cause === "string" ? error.cause : "";

export class Calls {
  #pending = new Map<number, Call>();
  #next = 0;

  /**
   * Starts a call. Returns its id for the wire and a promise of the answer. The promise rejects with a sentence, also
   * when the service refuses.
   */
  begin(service: string, timeoutMs = kTimeoutMs): { id: number; answer: Promise<Answer> } {
    const id = this.#next++;
    const answer = new Promise<unknown>((resolve, reject) => {
      const timer = setTimeout(() => this.fail(id, `The robot did not answer '${service}' in time.`), timeoutMs);
      this.#pending.set(id, { service, resolve, reject, timer });
    });
    return { id, answer: answer.then((value) => accepted(service, value)) };
  }

  answer(id: number, encoding: string, data: Uint8Array): void {
    if (encoding !== "json") return this.fail(id, `The robot answered in '${encoding}', expected json.`);
    let value: unknown;
    try {
      value = JSON.parse(new TextDecoder().decode(data));
    } catch {
      return this.fail(id, "The robot answered with something that is not JSON.");
    }
    this.#end(id)?.resolve(value);
  }

  fail(id: number, sentence: string): void {
    this.#end(id)?.reject(new Error(sentence));
  }

  failAll(sentence: string): void {
    for (const id of [...this.#pending.keys()]) this.fail(id, sentence);
  }

  #end(id: number): Call | undefined {
    const call = this.#pending.get(id);
    clearTimeout(call?.timer);
    this.#pending.delete(id);
    return call;
  }
}

/** Our services refuse inside a normal answer: {"ok": false, "error": "sentence", "cause": "token"}. */
function accepted(service: string, value: unknown): Answer {
  if (typeof value !== "object" || value === null)
    throw new Error(`The robot's answer to '${service}' is not an object.`);
  const answer = value as Answer;
  if (answer["ok"] === false)
    throw new Error(String(answer["error"] ?? `The robot refused '${service}' without a reason.`), {
      cause: answer["cause"],
    });
  return answer;
}
