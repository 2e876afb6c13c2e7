package badlog.html

import badlog.recording.Recording
import java.nio.file.Path

/**
 * What an export has made.
 *
 * @property page the page, as an absolute path.
 * @property recording the topics, values, counts and problems of the input, without its samples.
 * @property originalBytes the size of the input; these very bytes are in the page.
 * @property inflatedBytes how many bytes the recording has once it is inflated; [originalBytes] unless the input is
 *   gzip.
 */
public class ExportReport internal constructor(
    public val page: Path,
    public val recording: Recording,
    public val originalBytes: Long,
    public val inflatedBytes: Long,
)
