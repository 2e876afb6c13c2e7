package badlog.core.recording

// Problems of a topic that can occur in any format.

/** Reports that texts of [topic] are not UTF-8, the first of them on [line]. */
public fun ProblemList.addNotUtf8(topic: String, line: Int? = null) {
    add(ProblemKind.NOT_UTF8, "Texts in “$topic” are not UTF-8; they were read as Windows-1252.", line, topic)
}

/** Reports the samples of [topic] that are not finite, if there are any. The message calls them [samples]. */
public fun ProblemList.addNotFinite(topic: Topic, samples: String) {
    val count = topic.counts.notFinite
    if (count == 0) return
    val message = "“${topic.name}” is NaN or infinite in $count of ${topic.counts.total} $samples; these are kept, and drawn as gaps."
    add(ProblemKind.NOT_FINITE, message, topic = topic.name, count = count)
}

/** Reports that [count] whole numbers of [topic] lost their last digits. */
public fun ProblemList.addRounded(topic: String, count: Int) {
    val message = "Whole numbers in “$topic” are too large to be kept exactly${timesText(count)}."
    add(ProblemKind.NUMBERS_ROUNDED, message, topic = topic, count = count)
}
