// What the page begins with: it dresses the page, fills it and lets its scripts run, which stand in it by gzip, as its style and its body do. The policy knows them by
// their hashes as they are here, unpacked.

import { unzipped } from "letters";
import { notStarted } from "fault";

try {
  const style = document.createElement("style");
  style.textContent = await unzipped("style-packed").text();
  document.head.append(style);
  document.body.insertAdjacentHTML("afterbegin", await unzipped("body-packed").text());
  // The veil that the page began with: nobody sees it undressed.
  document.documentElement.style.visibility = "";
  for (const [id, type, from] of [["glue", "text/javascript", "glue-packed"], ["page", "module", "page-packed"]]) {
    const script = Object.assign(document.createElement("script"), { id, type });
    script.textContent = await unzipped(from).text();
    document.body.append(script);
  }
} catch (error) {
  document.documentElement.style.visibility = "";
  notStarted(error);
}
