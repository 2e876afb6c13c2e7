package badlog.page.view

import badlog.core.recording.Severity

/**
 * The note, event and findings under a cursor.
 *
 * @property said the text of the note there, otherwise of the event; null if there is neither.
 * @property severity the severity of the first finding there; null if there is none.
 * @property found the text of the findings; empty if there are none.
 */
internal class MarksAtCursor(val said: String?, val severity: Severity?, val found: String)
