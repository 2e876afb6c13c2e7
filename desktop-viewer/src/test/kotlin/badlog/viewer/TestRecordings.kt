package badlog.viewer

import badlog.analysis.LogView
import badlog.bag.BagParser
import badlog.viewer.recording.OpenRecording
import java.nio.file.Path

/** The recording that [text] is as a bag, as if it were in a file called [name]. */
internal fun recordingOf(text: String, name: String = "test.bag"): OpenRecording {
    val bytes = text.encodeToByteArray()
    val parser = BagParser(bytes.size.toLong())
    parser.accept(bytes)
    return OpenRecording(Path.of(name).toAbsolutePath(), LogView.of(parser.finish()))
}

/** A bag of [topics], each a name with attributes behind bars, of which `Time` is x; [rows] as they stand in the file. */
internal fun bagOf(topics: List<String>, rows: List<String>, values: Map<String, String> = emptyMap()): String {
    val header = topics.joinToString(",", """{"topics":[""", "],") { topic ->
        val attributes = topic.split('|').drop(1).joinToString(",") { "\"$it\"" }
        """{"name":"${topic.substringBefore('|')}","unit":"V","attrs":[$attributes]}"""
    } + values.entries.joinToString(",", "\"values\":[", "]}") { (name, value) -> """{"name":"$name","value":"$value"}""" }
    return (listOf(header, topics.joinToString(",") { it.substringBefore('|') }) + rows).joinToString("\n", postfix = "\n")
}
