package badlog.signals.match

import java.time.Instant
import java.time.ZoneId

actual fun localSecondOf(second: Long): Long = second + ZoneId.systemDefault().rules.getOffset(Instant.ofEpochSecond(second)).totalSeconds
