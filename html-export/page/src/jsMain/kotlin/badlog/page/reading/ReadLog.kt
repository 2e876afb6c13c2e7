package badlog.page.reading

import badlog.core.recording.Recording
import org.w3c.files.Blob

/**
 * A recording that was read.
 *
 * @property isDamaged whether the page was changed since it was exported, so that anything in [recording] may be wrong.
 * @property made the log of a match, made of several logs, as a WPILOG; null for a log that was read as it is.
 */
internal class ReadLog(val recording: Recording, val isDamaged: Boolean, val made: Blob? = null)
