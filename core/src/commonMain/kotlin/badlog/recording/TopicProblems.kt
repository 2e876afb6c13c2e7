package badlog.recording

// What may be odd about a topic, whatever file it is from.

/** The texts of [topic], in [line] for the first time, are not UTF-8. */
public fun ProblemList.addNotUtf8(topic: String, line: Int? = null) {
    add(ProblemKind.NOT_UTF8, "Texts in “$topic” are not UTF-8; they were read as Windows-1252.", line, topic)
}

/** Some of the [samples] of [topic] are no finite numbers, if it is so. */
public fun ProblemList.addNotFinite(topic: Topic, samples: String) {
    val count = topic.counts.notFinite
    if (count == 0) return
    val message = "“${topic.name}” is NaN or infinite in $count of ${topic.counts.total} $samples; these are kept, and drawn as gaps."
    add(ProblemKind.NOT_FINITE, message, topic = topic.name, count = count)
}
