package badlog.samples

import java.io.File

/** The sample files by name, each with the function that makes it. */
val SAMPLES: Map<String, () -> ByteArray> = mapOf(
    "qualification-42.bag" to ::qualification42,
    "qualification-57.bag.gz" to ::qualification57Compressed,
    "practice.bag" to ::practiceRun,
    "wrong-turn.bag" to ::wrongTurn,
    "elevator-bench.csv" to ::elevatorBench,
)

/** Writes the samples into the folder that the first argument names. */
fun main(arguments: Array<String>) {
    val folder = File(arguments.single())
    for ((name, make) in SAMPLES) {
        val bytes = make()
        File(folder, name).writeBytes(bytes)
        println("$name: ${bytes.size} bytes")
    }
}
