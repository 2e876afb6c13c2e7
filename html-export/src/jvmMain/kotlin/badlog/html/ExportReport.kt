package badlog.html

import badlog.recording.Recording
import java.nio.file.Path

/**
 * The result of an export.
 *
 * @property page the page, as an absolute path.
 * @property recording the topics, values, counts and problems of the input, without its samples.
 * @property originalBytes the size of the input; exactly these bytes are in the page.
 * @property inflatedBytes the size of the recording once it is inflated; [originalBytes] unless the input is gzip.
 */
public class ExportReport internal constructor(
    public val page: Path,
    public val recording: Recording,
    public val originalBytes: Long,
    public val inflatedBytes: Long,
)
