// The page's second thread: an explorer of its own, asked what takes longer than a picture. It stands in the page as text, behind the
// library.

onmessage = async ({ data: { compiled, what, handedOn } }) => {
  await wasm_bindgen({ module_or_path: compiled });
  const explorer = new wasm_bindgen.Explorer();
  explorer.ask(what, handedOn);
  for (let part = explorer.next_part(); part !== undefined; part = explorer.next_part()) postMessage(part);
  postMessage(null);
  close();
};
