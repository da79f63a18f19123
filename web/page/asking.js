// Questions that take longer than a picture, asked of a second thread: the answer comes part by part, and each is drawn as it comes.

import { byId } from "dom";

export function connectAsking(app) {
  const source = URL.createObjectURL(new Blob([byId("glue").textContent, byId("worker").textContent], { type: "text/javascript" }));
  const answers = {};
  const begin = (what, of) => {
    answers[what]?.worker?.terminate();
    const worker = new Worker(source);
    const answer = (answers[what] = { of, from: app.explorer, parts: [], done: false, fault: "", worker });
    const end = (fault) => {
      Object.assign(answer, { done: true, fault, worker: null });
      app.changed();
    };
    worker.onmessage = ({ data }) => {
      if (data === null) return end("");
      answer.parts.push(JSON.parse(data));
      app.changed();
    };
    worker.onerror = ({ message }) => end(message || "its thread did not start");
    worker.postMessage({ compiled: app.compiled, what, handedOn: app.explorer.handed_on() });
  };
  /** The answer to a question on the case as it stands, as far as it is known: its parts, whether that is all, and what went wrong. While
   * something is dragged it is the answer from before. */
  app.asked = (what) => {
    const of = app.explorer.answers();
    if ((answers[what]?.of !== of || answers[what].from !== app.explorer) && !app.held) begin(what, of);
    return answers[what] ?? { parts: [], done: false, fault: "" };
  };
}
