// Questions of a window that is a frame in a notebook go to the page around it; see widget.js.
{
  const waiting = new Map();
  let last = 0;
  globalThis.ask = (path, body) => new Promise((answered) => {
    waiting.set(++last, answered);
    parent.postMessage({ id: last, path, body }, "*");
  });
  addEventListener("message", ({ source, data: { id, media, name, data } }) => {
    if (source !== parent) return;
    const headers = { "content-type": media, ...(name && { "content-disposition": "attachment" }) };
    waiting.get(id)?.(new Response(data, { headers }));
    waiting.delete(id);
  });
}
