// The window in a cell: questions of the frame go to Python, and its answers go to the frame.

export default {
  render({ model, el }) {
    const frame = document.createElement("iframe");
    frame.setAttribute("sandbox", "allow-scripts allow-downloads");
    frame.allow = "fullscreen";
    frame.title = model.get("title");
    frame.style.cssText = "width: 100%; height: 46rem; border: 0";
    frame.srcdoc = model.get("page");
    const ask = ({ source, data }) => { if (source === frame.contentWindow) model.send(data); };
    const answer = (message, buffers) => frame.contentWindow?.postMessage({ ...message, data: buffers[0] }, "*");
    addEventListener("message", ask);
    model.on("msg:custom", answer);
    el.append(frame);
    return () => {
      removeEventListener("message", ask);
      model.off("msg:custom", answer);
    };
  },
};
