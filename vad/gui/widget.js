// The window in a cell: questions of the frame go to Python, and its answers go to the frame. What a
// hand sets in the frame is the trait "pose", what Python asks it to show "asked".

export default {
  render({ model, el }) {
    const frame = document.createElement("iframe");
    frame.setAttribute("sandbox", "allow-scripts allow-downloads");
    frame.allow = "fullscreen";
    frame.title = model.get("title");
    frame.style.cssText = "width: 100%; height: 46rem; border: 0";
    frame.srcdoc = model.get("page");
    let stands = false;
    const show = () => {
      const { pose } = model.get("asked") ?? {};
      if (stands && pose) frame.contentWindow?.postMessage({ vad: { pose } }, "*");
      return pose;
    };
    const hear = ({ source, data }) => {
      if (source !== frame.contentWindow) return;
      if (data.high) frame.style.height = `${data.high}px`;
      else if (!data.vad) model.send(data);
      else if (!stands) {
        stands = true;
        if (!show() && data.vad.pose) follow(data.vad.pose);
      } else if (data.vad.pose) follow(data.vad.pose);
    };
    const follow = (pose) => {
      model.set("pose", pose);
      model.save_changes();
    };
    const answer = (message, buffers) => frame.contentWindow?.postMessage({ ...message, data: buffers[0] }, "*");
    addEventListener("message", hear);
    model.on("msg:custom", answer);
    model.on("change:asked", show);
    el.append(frame);
    return () => {
      removeEventListener("message", hear);
      model.off("msg:custom", answer);
      model.off("change:asked", show);
    };
  },
};
