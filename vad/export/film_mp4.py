"""A film as MP4: H.264 at constant rate, which every player and slide program shows.

Only what changed is converted from RGB to the planes of H.264 (luma in full and chroma at half the
resolution, 4:2:0, BT.709); a pause repeats the same planes.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from fractions import Fraction
from itertools import count, islice
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from vad import gate
from vad.errors import ExportError, UsageError
from vad.export.frames import Film, Progress, painted, rate, with_boxes
from vad.export.lesson_srt import Cue, cues
from vad.lecture.chapters import Chapter, chapters
from vad.lecture.lesson import Lesson
from vad.lecture.turn import Turn
from vad.painting.film import Box, Frame
from vad.strokes.description import title

if TYPE_CHECKING:
    from av.container import OutputContainer
    from av.subtitles.stream import SubtitleStream
    from av.video.stream import VideoStream


# The presets are not made for line drawings.  x264's adaptive quantiser and its look-ahead take
# bits from sharp edges: "veryfast" at the same crf halves the file, but takes 1.6 times as long and
# has four times the error.  "ultrafast" does without both; CABAC and small intra blocks save a
# tenth of its bytes.  One quantiser for all pictures, instead of a rate that is steered, takes
# three quarters of the time and 9/10 of the bytes, with half the greatest error.  Chroma samples
# lie amid the 2 × 2 pixels they average.
_X264 = {
    "preset": "ultrafast",
    "qp": "13",
    "x264-params": "cabac=1:partitions=i4x4:chromaloc=1",
}
# In a turn all moves at once: with a look-ahead, and a rate that is steered, it takes a quarter of
# the bytes, and no edge looks different.
_X264_OF_TURN = {"preset": "veryfast", "crf": "21", "x264-params": "chromaloc=1"}
#: The bytes depend on the number of threads; more than two gain nothing on such pictures.
_THREADS = 2
#: The most threads that x264 takes; 0 lets it choose.
_MOST_THREADS = 128
#: How many pictures may be painted before they are encoded.
_AHEAD = 8
_SECONDS_BETWEEN_KEY_FRAMES = 10
_BT709 = 1
_LIMITED_RANGE = 1
_LANGUAGES = {"en": "eng", "de": "deu", "es": "spa", "fr": "fra", "it": "ita"}
_MILLISECOND = Fraction(1, 1000)
Bytes = NDArray[np.uint8]
# ITU-R BT.709, item 3: luma from R, G, B in [0, 1], colour differences, and the ranges of
# 8-bit samples (219 and 224 of 255 steps above 16 and about 128).
_RED, _GREEN, _BLUE = 0.2126, 0.7152, 0.0722
_LUMA = 219 / 255 * np.array([_RED, _GREEN, _BLUE])
_CB = 224 / 255 / (2 - 2 * _BLUE) * np.array([-_RED, -_GREEN, 1 - _BLUE])
_CR = 224 / 255 / (2 - 2 * _RED) * np.array([1 - _RED, -_GREEN, -_BLUE])
_HEAD = 8  # bytes: length and kind
_LONG = 16  # of an atom whose length takes 64 bits
_TO_THE_END = 0
_FLAGS = 3  # where the last byte of the flags lies in an atom's content
_ENABLED = 1
#: The place of the subtitles among the tracks: after the pictures, before the chapters.
_SUBTITLES = 1


def write(
    lesson: Film,
    stream: BinaryIO,
    *,
    progress: Progress | None = None,
    subtitles: bool = True,
    threads: int = _THREADS,
) -> None:
    """Write ``lesson`` to ``stream``, a file on disk; with ``subtitles``, captions as a track.

    The picture shows the captions, so that players leave the track off until they are asked.
    ``threads`` is how many the encoder uses; the bytes depend on it.

    Raises
    ------
    vad.errors.UsageError
        If the width or height is odd.
    """
    _check_even(lesson.size)
    threads = gate.whole("threads", threads, 0, _MOST_THREADS)
    encode(
        painted(lesson, progress),
        stream,
        size=lesson.size,
        rate=rate(lesson.fps),
        subtitles=cues(lesson) if subtitles and isinstance(lesson, Lesson) else (),
        language=lesson.sheet.language,
        title=title(lesson.sheet),
        parts=chapters(lesson) if isinstance(lesson, Lesson) else (),
        codec=_X264_OF_TURN if isinstance(lesson, Turn) else _X264,
        threads=threads,
    )


def _check_even(size: tuple[int, int]) -> None:
    """Raise `vad.errors.UsageError` for a size that H.264 with half-size chroma cannot have."""
    width, height = size
    if width % 2 or height % 2:
        even = f"{width + width % 2}x{height + height % 2}"
        message = f"size: MP4 needs an even width and height, got {width}x{height}"
        raise UsageError(message, hint=f"try {even}")


def encode(
    frames: Iterable[Frame],
    stream: BinaryIO,
    *,
    size: tuple[int, int],
    rate: Fraction,
    subtitles: Sequence[Cue] = (),
    language: str = "en",
    title: str = "",
    parts: Sequence[Chapter] = (),
    codec: Mapping[str, str] = MappingProxyType(_X264),
    threads: int = _THREADS,
) -> None:
    """Encode ``frames`` of ``size`` (width, height) at ``rate``, with the options of ``codec``.

    ``parts`` are the chapters of the film.
    """
    import av

    # FFmpeg opens the file by its name: to put the index in front it must read what it wrote.
    # "bitexact" leaves out dates and versions, so that the same film has the same bytes.
    options = {"movflags": "+faststart", "fflags": "+bitexact"}
    try:
        with av.open(stream.name, "w", format="mp4", options=options) as container:
            container.metadata["title"] = title
            container.set_chapters(
                [
                    {
                        "id": number,
                        "start": part.start,
                        "end": part.end,
                        "time_base": 1 / rate,
                        "metadata": {"title": part.title},
                    }
                    for number, part in enumerate(parts)
                ]
            )
            video = _video_stream(container, size, rate, codec, threads)
            track = _subtitle_stream(container, language) if subtitles else None
            container.start_encoding()
            if track is not None:
                _write_cues(container, track, subtitles)
            _write_frames(container, video, converted(frames, size))
        if track is not None:
            leave_off_track(stream, _SUBTITLES)
    except av.FFmpegError as error:
        if isinstance(error, OSError):
            raise
        message = f"the film cannot be encoded: {error.strerror}"
        raise ExportError(message, hint="try a smaller size") from error


def _video_stream(
    container: OutputContainer,
    size: tuple[int, int],
    rate: Fraction,
    options: Mapping[str, str],
    threads: int,
) -> VideoStream:
    video = container.add_stream("libx264", rate=rate, options=dict(options))
    video.width, video.height = size
    video.pix_fmt = "yuv420p"
    codec = video.codec_context
    codec.time_base = 1 / rate
    codec.thread_count = threads
    codec.gop_size = max(1, round(rate * _SECONDS_BETWEEN_KEY_FRAMES))
    codec.max_b_frames = 0
    codec.color_range = _LIMITED_RANGE
    codec.colorspace = codec.color_primaries = codec.color_trc = _BT709
    return video


def _write_frames(
    container: OutputContainer,
    video: VideoStream,
    changes: Iterable[tuple[list[Samples], int]],
) -> None:
    """Encode in a thread of its own, so that painting does not wait for it."""
    from av import VideoFrame

    picture = VideoFrame(video.width, video.height, "yuv420p")
    planes = [_samples(plane) for plane in picture.planes]
    times = count()

    def show(changed: list[Samples], repeats: int) -> None:
        for samples in changed:
            samples.store(planes)
        for time in islice(times, repeats):
            picture.pts = time
            container.mux(video.encode(picture))

    with ThreadPoolExecutor(1) as encoder:
        ahead: deque[Future[None]] = deque()
        try:
            for changed, repeats in changes:
                ahead.append(encoder.submit(show, changed, repeats))
                if len(ahead) > _AHEAD:
                    ahead.popleft().result()
            for each in ahead:
                each.result()
        except BaseException:
            encoder.shutdown(cancel_futures=True)
            raise
    container.mux(video.encode(None))


def _samples(plane: Any) -> Bytes:
    """Return the samples of one plane of a picture as an array that shares its memory."""
    rows = np.frombuffer(plane, np.uint8).reshape(-1, plane.line_size)
    return rows[: plane.height, : plane.width]


def _subtitle_stream(container: OutputContainer, language: str) -> SubtitleStream:
    track = container.add_stream("mov_text")
    track.codec_context.subtitle_header = b"[Script Info]\nScriptType: v4.00+\n"
    track.codec_context.time_base = track.time_base = _MILLISECOND
    track.metadata["language"] = _LANGUAGES.get(language, "und")
    return track


def _write_cues(
    container: OutputContainer, track: SubtitleStream, subtitles: Iterable[Cue]
) -> None:
    from av import Packet

    for cue in subtitles:
        text = cue.text.encode()
        packet = Packet(len(text).to_bytes(2, "big") + text)
        start = round(cue.start * 1000)
        packet.stream = track
        packet.time_base = _MILLISECOND
        packet.pts = packet.dts = start
        packet.duration = round(cue.end * 1000) - start
        container.mux(packet)


def even(box: Box) -> Box:
    """Return ``box`` grown to even pixels, where chroma samples begin and end.

    Examples
    --------
    >>> even((3, 4, 9, 10))
    (2, 4, 10, 10)
    """
    left, top, right, bottom = box
    return left & ~1, top & ~1, (right + 1) & ~1, (bottom + 1) & ~1


@dataclass(frozen=True, slots=True)
class Samples:
    """The samples of one box of a picture (in pixels, all even), to be stored in its planes."""

    box: Box
    y: Bytes
    cb: Bytes
    cr: Bytes

    def store(self, planes: Sequence[Bytes]) -> None:
        """Write the samples into the three planes of a picture."""
        left, top, right, bottom = self.box
        luma = slice(top, bottom), slice(left, right)
        chroma = slice(top // 2, bottom // 2), slice(left // 2, right // 2)
        y, cb, cr = planes
        y[luma], cb[chroma], cr[chroma] = self.y, self.cb, self.cr


def converted(
    frames: Iterable[Frame], size: tuple[int, int]
) -> Iterator[tuple[list[Samples], int]]:
    """Yield the samples that change with each frame, and for how many pictures they stand."""
    for frame, boxes in with_boxes(frames, size):
        yield [convert(frame.pixels, box) for box in boxes], frame.repeats


def convert(pixels: Bytes, box: Box) -> Samples:
    """Return the samples of ``box`` of an RGBA picture of even size."""
    left, top, right, bottom = box = even(box)
    window = pixels[top:bottom, left:right]
    # One channel at a time: three times as fast as a product of the pixels with a matrix.
    channels = [window[..., i].astype(np.float32) for i in range(3)]
    halves = [channel[0::2] + channel[1::2] for channel in channels]
    quarters = [half[:, 0::2] + half[:, 1::2] for half in halves]
    return Samples(
        box,
        _weighted(channels, _LUMA, 16.0),
        _weighted(quarters, _CB / 4, 128.0),
        _weighted(quarters, _CR / 4, 128.0),
    )


def _weighted(
    channels: list[NDArray[np.float32]], weights: NDArray[np.float64], offset: float
) -> Bytes:
    red, green, blue = (np.float32(weight) for weight in weights)
    total = channels[0] * red
    total += channels[1] * green
    total += channels[2] * blue
    total += np.float32(offset + 0.5)  # to round where the conversion cuts off
    return total.astype(np.uint8)


def leave_off_track(stream: BinaryIO, number: int) -> None:
    """Let players show a track, counted from 0, when they are asked to, and not before."""
    film = next(place for kind, *place in _atoms(stream, 0, stream.seek(0, 2)) if kind == b"moov")
    tracks = [place for kind, *place in _atoms(stream, *film) if kind == b"trak"]
    header = next(place for kind, *place in _atoms(stream, *tracks[number]) if kind == b"tkhd")
    stream.seek(header[0] + _FLAGS)
    flags = stream.read(1)[0]
    stream.seek(header[0] + _FLAGS)
    stream.write(bytes([flags & ~_ENABLED]))


def _atoms(stream: BinaryIO, start: int, end: int) -> Iterator[tuple[bytes, int, int]]:
    """Yield kind, start and end of the content of each atom between two places."""
    # Each round goes on by the head of an atom, at least.
    while start < end:
        stream.seek(start)
        head = stream.read(_LONG)
        length, content = int.from_bytes(head[:4], "big"), start + _HEAD
        if length == 1:
            length, content = int.from_bytes(head[8:], "big"), start + _LONG
        after = end if length == _TO_THE_END else max(start + length, content)
        yield head[4:8], content, after
        start = after
