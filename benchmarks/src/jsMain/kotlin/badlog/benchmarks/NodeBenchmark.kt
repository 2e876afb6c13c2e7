package badlog.benchmarks

import badlog.core.bag.BagParser
import badlog.core.bag.RowWriter
import kotlin.math.sin

private external interface Process {
    val argv: Array<String>

    fun hrtime(): Array<Double>
}

private external val process: Process

private external fun require(module: String): dynamic

private const val ROUNDS = 8

/**
 * Prints the speed of core's parser on Node in MB/s. It is the best of some rounds over a synthetic bag, or over the file in the argument.
 */
fun main() {
    val file = process.argv.getOrNull(2)
    val bag = if (file == null) syntheticBag() else bytesOf(file)
    val best = (0 until ROUNDS).maxOf {
        val before = process.hrtime()
        val parser = BagParser(bag.size.toLong())
        parser.accept(bag)
        parser.finish()
        val after = process.hrtime()
        bag.size / 1e6 / (after[0] - before[0] + (after[1] - before[1]) / 1e9)
    }
    println("parser on Node: ${best.toInt()} MB/s")
}

private fun bytesOf(file: String): ByteArray {
    val buffer = require("fs").readFileSync(file)
    return js("new Int8Array(buffer.buffer, buffer.byteOffset, buffer.length)").unsafeCast<ByteArray>()
}

/** Returns a bag of 20,000 rows of 50 noisy sines. */
private fun syntheticBag(): ByteArray {
    val writer = RowWriter()
    repeat(50) { writer.text("Signal $it") }
    writer.endRow()
    for (row in 0 until 20_000) {
        for (i in 0 until 50) writer.number((1 + i % 7) * sin(row * 0.001 * i) + i + row * 31 % 97 * 0.001)
        writer.endRow()
    }
    return writer.bytes.copyOf(writer.size)
}
