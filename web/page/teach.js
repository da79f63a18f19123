// Stories: steps of a case, a headline and some words, that take the whole page. Each is told by an explorer of its own, so that the
// person's case, with the texts before it, waits as it was.

import { Explorer } from "library";
import { byId, element, put } from "dom";
import { embedded } from "embed";
import { room } from "room";

const root = document.documentElement;

export function connectTeach(app) {
  const stories = JSON.parse(Explorer.stories());
  const dots = byId("story-dots");
  const [back, next] = [byId("story-back"), byId("story-next")];
  let own = null;
  let story = null;
  let at = 0;
  let ownTab = "";
  app.story = null;

  /** The case of a step, as if a person had opened it and typed its numbers. */
  const told = (of, number) => {
    const { case: name, set = {} } = of.steps[number];
    const explorer = new Explorer();
    const lines = of.cases?.[name];
    if (lines) explorer.open(name, lines.join("\n"));
    else explorer.open_example(name);
    for (const [key, value] of Object.entries(set)) explorer.set(key, value);
    explorer.open(`${of.id}-${number + 1}.toml`, explorer.text());
    explorer.forget();
    return explorer;
  };
  const step = () => story.steps[at];
  /** Puts a tab's answer into the place of the plane; without a name it goes back to where it was. */
  const showTab = (name) => {
    root.dataset.tab = name;
    if (name) byId("story-tab").append(byId(`panel-${name}`));
    else for (const panel of [...byId("story-tab").children]) byId("panel-inputs").before(panel);
    app.showTab(name || ownTab);
  };
  const show = (number) => {
    at = Math.min(Math.max(number, 0), story.steps.length - 1);
    if (app.explorer !== own) app.explorer.free();
    app.explorer = told(story, at);
    app.story = { id: story.id, step: at + 1, hold: step().hold, tab: step().tab };
    app.plate = step().plate ?? "";
    showTab(step().tab ?? "");
    app.showBody(step().body);
    app.startAt = undefined;
    const { head, words, do: task = "", figure = "" } = step();
    put(byId("story-place"), `${story.title} · ${at + 1} of ${story.steps.length}`);
    put(byId("story-head"), head);
    byId("story-words").replaceChildren(words, ...(task ? [" ", element("em", {}, task)] : []));
    byId("story-figure").innerHTML = figure && Explorer.report_figure(figure);
    root.dataset.figure = figure;
    back.disabled = at === 0;
    put(next, at + 1 < story.steps.length ? "Next ›" : "End ›");
    dots.replaceChildren(...story.steps.map((_, i) => {
      const dot = element("button", { type: "button" });
      dot.setAttribute("aria-label", `Step ${i + 1}`);
      if (i === at) dot.setAttribute("aria-current", "step");
      dot.addEventListener("click", () => {
        show(i);
        dots.children[i].focus();
      });
      return dot;
    }));
    put(byId("live"), `${byId("story-place").textContent}. ${head} ${words} ${task}`);
    scrollTo(0, 0);
    app.changed();
  };
  const go = (way) => {
    if (way > 0 && at + 1 === story.steps.length) return leave(false);
    show(at + way);
    if (back.disabled && document.activeElement === document.body) next.focus();
  };
  /** Tells a story from a step on, counted from 1; false if there is none of that name. */
  app.tell = (id, from = 1) => {
    const found = stories.find((one) => one.id === id);
    if (!found) return false;
    if (!story) {
      app.settleText();
      own = app.explorer;
      ownTab = app.tab;
      root.dataset.story = "";
    }
    story = found;
    show((Number.isInteger(from) ? from : 1) - 1);
    byId("story-head").focus({ preventScroll: true });
    return true;
  };
  /** Ends the story: the person's own case is back, or that of the step is taken over. */
  const leave = (keep) => {
    if (!story) return;
    app.settleText();
    const [name, text] = [app.explorer.name(), app.explorer.text()];
    app.explorer.free();
    app.explorer = own;
    if (keep) own.open(name, text);
    else app.plate = "";
    story = own = app.story = null;
    showTab("");
    delete root.dataset.tab;
    delete root.dataset.story;
    delete root.dataset.figure;
    app.showBody("");
    app.changed();
    byId("teach-menu").querySelector("summary").focus();
  };
  app.leaveStory = () => leave(false);

  back.addEventListener("click", () => go(-1));
  next.addEventListener("click", () => go(1));
  byId("story-leave").addEventListener("click", () => leave(false));
  byId("story-keep").addEventListener("click", () => leave(true));
  byId("story-print").addEventListener("click", () => print());
  byId("story-embed").addEventListener("click", () => embedded(app, ""));
  addEventListener("keydown", (event) => {
    if (!story || event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey || app.held) return;
    // Where a field, a slider or a ring has these keys, they are its.
    const busy = event.target.closest?.("input, textarea, select, [role=slider], .point, .ring, [role=tab]");
    const action = { ArrowRight: () => go(1), ArrowLeft: () => at > 0 && go(-1), Escape: () => leave(false) }[event.key];
    if (!action || (busy && (event.key !== "Escape" || busy.matches("input, textarea, select")))) return;
    event.preventDefault();
    action();
  });

  byId("stories").append(...stories.map(({ id, title, words }) => {
    const choice = element("button", { type: "button" }, title, element("small", {}, words));
    choice.dataset.story = id;
    choice.addEventListener("click", () => {
      byId("teach-menu").open = false;
      // The browser's own way back leads out of it.
      history.pushState(null, "", `#teach=${id}&step=1`);
      app.tell(id);
    });
    return element("li", {}, choice);
  }));

  // A handout: the steps with their drawings, one on a page.
  addEventListener("beforeprint", () => {
    if (!story) return;
    byId("handout").replaceChildren(...story.steps.map((one, i) => {
      const explorer = told(story, i);
      const said = JSON.parse(explorer.said());
      const [body, plate] = [element("div", {}), element("div", {})];
      body.innerHTML = explorer.body_on_paper(one.body);
      plate.innerHTML = one.figure ? Explorer.report_figure(one.figure) : explorer.plane_on_paper(one.plate, 560, 400);
      explorer.free();
      return element("article", {}, element("p", { className: "hint" }, `${story.title} · ${i + 1} of ${story.steps.length}`), element("h2", {}, one.head),
        element("p", {}, one.words, " ", element("em", {}, one.do ?? "")), element("p", {}, said.summary.answer), body, plate);
    }));
  });
  addEventListener("afterprint", () => byId("handout").replaceChildren());
  return () => {
    if (!story) return;
    const place = byId("story-tab");
    if (step().tab) place.style.maxHeight = place.clientWidth > 0.6 * innerWidth ? "" : `${room(app, place, Infinity)}px`;
    document.title = `${story.title} · ${at + 1} of ${story.steps.length}`;
  };
}
