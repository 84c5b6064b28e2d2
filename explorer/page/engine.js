// The generator in a worker: the newest request is answered, older ones are dropped.

/** Longest time for an answer, in ms. */
const LIMIT = 20_000;
/** Time after which an answer is said to be awaited, in ms. */
const PATIENCE = 150;

const text = (id) => document.getElementById(id).textContent;

/** Answers requests: `ask(request)`, `onanswer(answer, request)`; `onbusy(text)` says what is awaited, an empty text that nothing is. */
export class Engine {
  #worker = null;
  #running = null;
  #next = null;
  #timer = 0;
  #patience = 0;
  #answered = false;

  constructor(onanswer, onbusy) {
    this.onanswer = onanswer;
    this.onbusy = onbusy;
    this.#start();
  }

  ask(request) {
    this.#next = request;
    if (!this.#running) this.#send();
  }

  get idle() {
    return !this.#running && !this.#next;
  }

  #send() {
    const request = this.#next;
    this.#running = request;
    this.#next = null;
    if (!this.#worker) this.#start();
    this.#timer = setTimeout(() => this.#stop(), LIMIT);
    this.#patience ||= setTimeout(() => this.onbusy(this.#answered ? "Computing" : "Starting the generator"), this.#answered ? PATIENCE : 0);
    this.#worker.postMessage({ request: JSON.stringify(request) });
  }

  #start() {
    const url = URL.createObjectURL(new Blob([text("worker")], { type: "text/javascript" }));
    this.#worker = new Worker(url);
    URL.revokeObjectURL(url);
    this.#worker.onmessage = ({ data }) => this.#end(JSON.parse(data.answer));
    this.#worker.onerror = (event) => this.#end({ fault: event.message });
    this.#worker.postMessage({ packed: text("engine") });
  }

  #stop() {
    this.#worker.terminate();
    this.#worker = null;
    const seconds = LIMIT / 1000;
    this.#end({ fault: `no answer within ${seconds} s. The command has no such limit.` });
  }

  #end(answer) {
    clearTimeout(this.#timer);
    const request = this.#running;
    this.#running = null;
    this.#answered = true;
    if (this.#next) this.#send();
    else {
      clearTimeout(this.#patience);
      this.#patience = 0;
      this.onbusy("");
    }
    this.onanswer(answer, request);
  }
}
