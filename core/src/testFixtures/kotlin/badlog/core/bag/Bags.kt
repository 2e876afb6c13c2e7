package badlog.core.bag

import badlog.core.recording.Recording

/** Reads [bytes] as one file that arrives in pieces of [piece] bytes. */
internal fun parse(bytes: ByteArray, piece: Int = maxOf(1, bytes.size)): Recording {
    val parser = BagParser()
    var at = 0
    while (at < bytes.size) {
        val end = minOf(at + piece, bytes.size)
        parser.accept(bytes, at, end)
        at = end
    }
    return parser.finish()
}

internal fun parse(text: String, piece: Int = Int.MAX_VALUE): Recording = parse(text.encodeToByteArray(), piece)

/** The content of a recording as text, so that two can be compared and differences are readable. */
internal fun describe(recording: Recording): String = buildString {
    appendLine("${recording.format.id} ${recording.rowCount} rows ${recording.headerLine}")
    for (value in recording.values) appendLine("value ${value.name}=${value.text}")
    for (topic in recording.topics) {
        val texts = List(topic.texts.size) { "${topic.texts.rows[it]}:${topic.texts[it]}" }
        appendLine("topic ${topic.name} ${topic.unit} ${topic.attributes} ${topic.kind} ${topic.counts}")
        appendLine("  ${topic.samples.toList()} $texts")
    }
    for (problem in recording.problems) appendLine(problem)
}

/** The two header lines of [VARIED_BAG]. */
internal val VARIED_HEADER: String = """
    {"topics":[{"name":"Time","unit":"s","attrs":["xaxis","hide"]},{"name":"Arm/Angle","unit":"deg","attrs":[]},
    {"name":"Log","unit":"ul","attrs":["log"]},{"name":"Enabled","unit":"ul","attrs":[]}],"values":[{"name":"Match","value":"8"}]}
""".trimIndent().replace("\n", "") + "\nTime,Arm/Angle,Log,Enabled\n"

/** The rows of [VARIED_BAG]. */
internal val VARIED_ROWS: List<String> = listOf(
    "0.0000,12.346,,false\n",
    "0.020000,-1.2346e+05,\"armed, ready\",false\n",
    "0.040000,,\"said \"\"go\"\"\ntwice\",true\n",
    "0.060000,1.0000e-05,,true\n",
    "0.080000,NaN,Ω ready,true\n",
    "0.10000,99.000,,true\n",
)

/** A small bag with a bit of everything: numbers, gaps, quoted texts with commas, newlines and quotes, true and false. */
internal val VARIED_BAG: String = VARIED_HEADER + VARIED_ROWS.joinToString("")
