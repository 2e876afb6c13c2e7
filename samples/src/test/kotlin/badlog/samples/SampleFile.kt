package badlog.samples

import badlog.core.analysis.LogView
import badlog.core.bag.BagParser
import badlog.core.recording.Topic
import java.io.ByteArrayOutputStream
import java.io.File
import java.util.zip.Inflater

/** Returns a checked-in sample; the tests run in the folder of the samples. */
fun sampleFile(name: String): File = File(name).also { check(it.isFile) { "$name is not in ${File("").absolutePath}" } }

/** Returns the sample as a front end reads it. */
fun viewOf(name: String): LogView {
    val file = sampleFile(name).readBytes()
    val parser = BagParser()
    parser.accept(if (name.endsWith(".gz")) Inflated(file).bytes else file)
    return LogView.of(parser.finish())
}

fun LogView.topic(name: String): Topic = recording.topics.single { it.name == name }

fun LogView.rowAt(seconds: Double): Int = xAxis.positions.indexOfFirst { it >= seconds }

/** Returns the samples of [topic] from second [from] until second [until]. */
fun LogView.samples(topic: String, from: Double, until: Double): List<Double> = topic(topic).samples.slice(rowAt(from) until rowAt(until))

fun LogView.events(): List<Pair<Double, String>> = folders.flatMap { it.eventLogs }.flatMap { it.events }.map { it.x to it.text }

/** The inflated content of a gzip [file], possibly cut off, and whether its stream has an end. */
class Inflated(file: ByteArray) {
    val bytes: ByteArray
    val isWhole: Boolean

    init {
        val inflater = Inflater(true)
        inflater.setInput(file, GZIP_HEADER, file.size - GZIP_HEADER)
        val out = ByteArrayOutputStream()
        val piece = ByteArray(1 shl 16)
        do {
            val count = inflater.inflate(piece)
            out.write(piece, 0, count)
        } while (count > 0)
        bytes = out.toByteArray()
        isWhole = inflater.finished()
        inflater.end()
    }
}

private const val GZIP_HEADER = 10
