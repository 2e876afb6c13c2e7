package badlog.formats.driverstation

import badlog.core.python.TestPython
import badlog.core.recording.Recording
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import java.io.File

/** Real logs of Driver Stations, below the folder that `BADLOG_REAL_LOGS` names. They are not part of the project. */
private val STATIONS: List<File> = System.getenv("BADLOG_REAL_LOGS")?.let { folder ->
    File(folder).walk().filter { it.extension == "dslog" || it.extension == "dsevents" }.sorted().toList()
}.orEmpty()

private val PYTHON = TestPython("struct", "Python")

private fun oracle(file: File): List<List<String>> {
    val process = PYTHON.running("src/jvmTest/python/read_station.py", file.parent, file.path)
    val lines = process.inputStream.bufferedReader().readLines().map { it.split(' ') }
    process.waitFor() shouldBe 0
    return lines
}

private fun Recording.samples(name: String) = topics.single { it.name == name }.samples

/** The bits of a status, which is inverted, as the modes that it says; null for none. */
private fun modeOf(status: Int): String? = listOf(1 to "Disabled", 2 to "Autonomous", 4 to "Teleop").find { status and it.first != 0 }?.second

@Tags("InCheck")
class RealStationsSpec : FunSpec({
    val where = { _: Any? ->
        when {
            STATIONS.none { File(it.parentFile, "oracle.py").exists() } -> Enabled.disabled("BADLOG_REAL_LOGS names no folder with Driver Station logs")
            PYTHON.command == null -> Enabled.disabled("there is no Python")
            else -> Enabled.enabled
        }
    }

    test("every value of a real .dslog equals another reader's").config(enabledOrReasonIf = where) {
        for (file in STATIONS.filter { it.extension == "dslog" }) {
            val read = parseStation(file.readBytes())
            val expected = oracle(file).drop(1).map { line -> line.map { it.toDouble() } }
            read.problems.shouldBeEmpty()
            read.topics.first().times?.size shouldBe expected.size
            fun texts(name: String) = read.topics.single { it.name == "Driver Station/$name" }.texts
            val (dsModes, robotModes) = texts("DS Mode") to texts("Robot Mode")
            fun station(name: String) = read.samples("Driver Station/$name")
            val power = read.topics.find { it.name.endsWith("/Channel 0") }
            val folder = power?.name?.substringBefore('/')
            val channels = read.topics.count { it.name.startsWith("$folder/Channel ") }
            var block = 0
            expected.forEachIndexed { i, record ->
                val (trip, loss, volts, cpu, status) = record
                withClue("${file.name}, record $i") {
                    station("Trip Time").getOrElse(i) { Double.NaN }.let { if (trip == 127.5) it.isNaN() shouldBe true else it shouldBe trip }
                    station("Packet Loss")[i] shouldBe ((loss * 100).coerceIn(0.0, 100.0) plusOrMinus 1e-9)
                    station("Battery Voltage").getOrElse(i) { Double.NaN }.let { if (volts > 255.99) it.isNaN() shouldBe true else it shouldBe volts }
                    for ((name, expectedUse) in listOf("CPU Utilization" to cpu, "CAN Utilization" to record[5])) {
                        val use = station(name).getOrElse(i) { Double.NaN }
                        if (volts > 255.99) use.isNaN() shouldBe true else use shouldBe (expectedUse * 100 plusOrMinus 1e-9)
                    }
                    val bits = status.toInt().inv()
                    station("Brownout")[i] shouldBe if (bits and 0x80 != 0) 1.0 else 0.0
                    station("Watchdog")[i] shouldBe if (bits and 0x40 != 0) 1.0 else 0.0
                    dsModes[i] shouldBe (modeOf(bits shr 3) ?: "Other")
                    modeOf(bits)?.let { robotModes[i] shouldBe it }
                    val amps = record.drop(6)
                    if (amps.isNotEmpty()) {
                        amps.size shouldBe channels
                        amps.forEachIndexed { channel, expectedAmps -> read.samples("$folder/Channel $channel")[block] shouldBe expectedAmps }
                        power?.times?.get(block) shouldBe i * 0.02
                        block++
                    }
                }
            }
        }
    }

    test("every entry of a real .dsevents is in its messages, at its time").config(enabledOrReasonIf = where) {
        for (file in STATIONS.filter { it.extension == "dsevents" }) {
            val read = parseStation(file.readBytes())
            read.format shouldBe DriverStationFormat
            read.problems.shouldBeEmpty()
            val entries = oracle(file).map { (time, hex) ->
                time.toDouble() to if (hex == "-") "" else hex.chunked(2).map { it.toInt(16).toByte() }.toByteArray().decodeToString()
            }
            val whole = entries.joinToString("\n") { it.second }
            fun count(text: String) = Regex(Regex.escape(text)).findAll(whole).count()
            fun sizeOf(name: String) = read.topics.single { it.name == "Driver Station/$name" }.size
            val blank = Regex("<message> +(?=<TagVersion>|\n|$)").findAll(whole).count()
            sizeOf("Console") shouldBe count("<message>") - blank
            sizeOf("roboRIO Disk Free") shouldBe count("Disk Free")
            val untagged = entries.sumOf { (_, text) ->
                text.substringBefore("<TagVersion>").split(Regex(" (?=Info |Warning |ERROR )")).count { it.isNotBlank() && "Disk Free" !in it }
            }
            sizeOf("Events") shouldBe count("<details>") + untagged
            val times = read.topics.flatMap { it.times?.toList().orEmpty() }.distinct()
            for ((time, text) in entries) {
                if (text.replace(Regex("<[^>]*>"), "").isNotBlank()) withClue("${file.name} at $time") { times.any { kotlin.math.abs(it - time) < 1e-6 } shouldBe true }
            }
        }
    }
})
