// What the page begins with: it lets the page's scripts run, which stand in it by gzip. The policy knows them by their hashes as they are
// here, unpacked.

import { unzipped } from "letters";
import { notStarted } from "fault";

try {
  for (const [id, type, from] of [["glue", "text/javascript", "glue-packed"], ["page", "module", "page-packed"]]) {
    const script = Object.assign(document.createElement("script"), { id, type });
    script.textContent = await unzipped(from).text();
    document.body.append(script);
  }
} catch (error) {
  notStarted(error);
}
