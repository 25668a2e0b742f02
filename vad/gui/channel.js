// Questions of a window that is a frame in a notebook go to the page around it; see widget.js.
{
  const waiting = new Map();
  let last = 0;
  globalThis.ask = (path, body) => new Promise((answered) => {
    waiting.set(++last, answered);
    parent.postMessage({ id: last, path, body }, "*");
  });
  addEventListener("message", ({ source, data: { id, media, name, data } }) => {
    if (source !== parent || !waiting.has(id)) return;
    const headers = { "content-type": media, ...(name && { "content-disposition": "attachment" }) };
    waiting.get(id)(new Response(data, { headers }));
    waiting.delete(id);
  });
  // How high the frame must be, so that the board is as wide as the cell; for the forms of the page
  // see page.css. A cell may be resized before there is a board.
  globalThis.stood = () => {
    const page = document.querySelector(".vad"), board = page?.querySelector(".board");
    if (!board) return;
    const high = board.style.getPropertyValue("--h"), rail = innerWidth >= 1024 ? page.querySelector(".rail").offsetWidth : 0;
    const width = innerWidth - rail, across = innerWidth < 768 ? 870 : 1280, more = page.querySelector(".tools").offsetHeight;
    if (high && innerWidth >= 480) parent.postMessage({ high: Math.ceil(width * high / across + 116 + more) }, "*");
  };
  addEventListener("resize", stood);
}
