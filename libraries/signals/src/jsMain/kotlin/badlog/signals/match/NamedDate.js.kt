package badlog.signals.match

import kotlin.js.Date

actual fun localSecondOf(second: Long): Long = second - Date(second.toDouble() * 1000).getTimezoneOffset() * 60L
