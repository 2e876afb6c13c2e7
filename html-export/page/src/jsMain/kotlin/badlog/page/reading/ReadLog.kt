package badlog.page.reading

import badlog.core.recording.Recording

/**
 * The recording read from a page.
 *
 * @property isDamaged whether the page was changed since it was exported, so that anything in [recording] may be wrong.
 */
internal class ReadLog(val recording: Recording, val isDamaged: Boolean)
