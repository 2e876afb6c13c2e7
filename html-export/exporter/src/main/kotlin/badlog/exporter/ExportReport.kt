package badlog.exporter

import badlog.core.recording.Recording
import java.nio.file.Path

/**
 * The result of an export.
 *
 * @property page the page, as an absolute path.
 * @property recording the topics, values, counts and problems of the input, without its samples.
 * @property originalBytes the size of the input; exactly these bytes are in the page.
 * @property inflatedBytes the size of the recording once it is inflated; equal to [originalBytes] unless the input is gzip.
 */
class ExportReport internal constructor(val page: Path, val recording: Recording, val originalBytes: Long, val inflatedBytes: Long)
