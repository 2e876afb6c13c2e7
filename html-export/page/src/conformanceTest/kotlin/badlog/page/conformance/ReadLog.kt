package badlog.page.conformance

import badlog.core.conformance.jsonReadFrom
import kotlin.io.encoding.Base64

/** Returns the page's recording of a log in [base64] that arrives in pieces of [piece] bytes; for pages of tests. */
@OptIn(ExperimentalJsExport::class)
@JsExport
public fun readLog(base64: String, piece: Int): String = jsonReadFrom(Base64.decode(base64), piece)
