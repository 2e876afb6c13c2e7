package badlog.window

import badlog.catalog.folder.wpilogOf
import badlog.core.analysis.LogView
import badlog.core.bag.BagParser
import badlog.core.recording.Topic
import badlog.formats.wpilog.WpilogParser
import badlog.window.log.OpenRecording
import java.nio.file.Path

/** Returns the recording of [text], the content of a bag called [name]. */
internal fun recordingOf(text: String, name: String = "test.bag"): OpenRecording {
    val bytes = text.encodeToByteArray()
    val parser = BagParser(bytes.size.toLong())
    parser.accept(bytes)
    return OpenRecording(Path.of(name).toAbsolutePath(), LogView.of(parser.finish()))
}

/** Returns a bag of [topics], each a name with attributes behind bars; `Time` is x. The file contains [rows] as they are. */
internal fun bagOf(topics: List<String>, rows: List<String>, values: Map<String, String> = emptyMap()): String {
    val header = topics.joinToString(",", """{"topics":[""", "],") { topic ->
        val attributes = topic.split('|').drop(1).joinToString(",") { "\"$it\"" }
        """{"name":"${topic.substringBefore('|')}","unit":"V","attrs":[$attributes]}"""
    } + values.entries.joinToString(",", "\"values\":[", "]}") { (name, value) -> """{"name":"$name","value":"$value"}""" }
    return (listOf(header, topics.joinToString(",") { it.substringBefore('|') }) + rows).joinToString("\n", postfix = "\n")
}

/** Returns the recording of a WPILOG of [topics]. */
internal fun wpilogRecording(vararg topics: Topic): OpenRecording {
    val parser = WpilogParser()
    parser.accept(wpilogOf(topics.toList()))
    return OpenRecording(Path.of("test.wpilog").toAbsolutePath(), LogView.of(parser.finish()))
}
