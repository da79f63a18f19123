// Questions that take longer than a picture, asked of a second thread: the answer comes part by part, and each is drawn as it comes.

import { byId } from "dom";

export function connectAsking(app) {
  const source = URL.createObjectURL(new Blob([byId("glue").textContent, byId("worker").textContent], { type: "text/javascript" }));
  /** Asks of the last text that has an answer, in a thread of its own, which is given back: `take` has each part, `end` what went wrong. */
  const begin = (what, take, end) => {
    const worker = new Worker(source);
    worker.onmessage = ({ data }) => (data === null ? end("") : take(JSON.parse(data)));
    worker.onerror = ({ message }) => end(message || "its thread did not start");
    worker.postMessage({ compiled: app.compiled, what, handedOn: app.explorer.handed_on() });
    return worker;
  };
  /** The one part of the answer to a question. */
  app.askOnce = (what) => new Promise((found, failed) => begin(what, found, (fault) => failed(new Error(fault || "there is no answer"))));

  const answers = {};
  /** The answer to a question on the case as it stands, as far as it is known: its parts, whether that is all, and what went wrong. Behind
   * the name of a question may stand what is asked more closely. While something is dragged it is the answer from before, as far as it came:
   * no thread works beside the hand on what is about to be another case. */
  app.asked = (what) => {
    const [name] = what.split(" ");
    if (app.held && answers[name]?.done === false) {
      answers[name].worker.terminate();
      answers[name].of = "";
    }
    const of = `${app.explorer.answers()} ${what}`;
    if ((answers[name]?.of !== of || answers[name].from !== app.explorer) && !app.held) {
      answers[name]?.worker.terminate();
      const answer = (answers[name] = { of, from: app.explorer, parts: [], done: false, fault: "" });
      const take = (part) => {
        answer.parts.push(part);
        app.changed();
      };
      answer.worker = begin(what, take, (fault) => {
        Object.assign(answer, { done: true, fault });
        app.changed();
      });
    }
    return answers[name] ?? { parts: [], done: false, fault: "" };
  };
}
