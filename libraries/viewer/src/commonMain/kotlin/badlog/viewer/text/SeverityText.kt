package badlog.viewer.text

import badlog.core.recording.Severity

/** What front ends call it. */
val Severity.word: String get() = name.lowercase()
