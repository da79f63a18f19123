// What the page begins with: it lets the page's scripts run, which stand in it by gzip. The policy knows them by their hashes as they are
// here, unpacked.

import { unzipped } from "letters";

try {
  for (const [id, type, from] of [["glue", "text/javascript", "glue-packed"], ["page", "module", "page-packed"]]) {
    const script = Object.assign(document.createElement("script"), { id, type });
    script.textContent = await unzipped(from).text();
    document.body.append(script);
  }
} catch (error) {
  const fault = document.getElementById("fault");
  fault.hidden = false;
  fault.textContent = `The explorer did not start in this browser: ${error}`;
  throw error;
}
