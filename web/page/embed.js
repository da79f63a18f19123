// A part of the page for a handout: as the text of an <iframe>, and as it stands in one.

import { byId, copy, element } from "dom";

export const PARTS = ["plane", "body", "verdict"];
/** Width and height of a frame, with the whole of a story where no part is named. */
const SIZES = { plane: [640, 460], body: [640, 460], verdict: [720, 170], "": [960, 680] };

/** Copies the text of a frame that shows a part of the page as it stands. */
export async function embedded(app, part) {
  app.settleText();
  const fragment = await app.fragment(part);
  const isOnDisk = location.protocol === "file:";
  const address = isOnDisk ? location.pathname.split("/").pop() : location.href.split("#")[0];
  const [width, height] = SIZES[part];
  const frame = element("iframe", { title: document.title });
  for (const [name, value] of Object.entries({ src: `${address}#${fragment}`, width, height, loading: "lazy" })) frame.setAttribute(name, value);
  await copy(frame.outerHTML, isOnDisk ? "Frame copied. Put this page’s file beside the one that it goes into." : "Frame copied: paste it into the HTML of a handout.");
}

export function connectEmbed(app) {
  for (const part of PARTS) {
    byId(`embed-${part}`).addEventListener("click", () => {
      byId("teach-menu").open = false;
      embedded(app, part);
    });
  }
}
