package badlog.page.view

import badlog.core.recording.Severity

/**
 * What a cursor points at.
 *
 * @property said the text of the note there, or else of the event; null for neither.
 * @property severity the severity of the first finding there; null for none.
 * @property found the text of the findings; empty for none.
 */
internal class Pointed(val said: String?, val severity: Severity?, val found: String)
