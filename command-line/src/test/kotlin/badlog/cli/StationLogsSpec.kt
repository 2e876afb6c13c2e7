package badlog.cli

import badlog.files.inFolder
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import badlog.formats.driverstation.STATION_EVENTS
import badlog.formats.driverstation.STATION_LOG
import badlog.formats.driverstation.TestDslog
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import kotlinx.serialization.json.jsonPrimitive
import java.nio.file.Path
import kotlin.io.path.div

class StationLogsSpec : FunSpec({
    val log = "2026_03_07 10_04_05 Sat.dslog"

    fun Path.pair() {
        with(log, STATION_LOG.bytes)
        with("2026_03_07 10_04_05 Sat.dsevents", STATION_EVENTS.bytes)
    }

    test("a pair is listed and read once, also where both files are named") {
        inFolder { folder ->
            folder.pair()
            for (arguments in listOf(listOf(folder), listOf(folder / log, folder / "2026_03_07 10_04_05 Sat.dsevents"))) {
                val json = badlogJson("info", *arguments.toTypedArray()).json.single()
                json.getValue("bytes").jsonPrimitive.content shouldBe (STATION_LOG.bytes.size + STATION_EVENTS.bytes.size).toString()
                json.getValue("format").jsonPrimitive.content shouldBe "driver_station"
            }
            val said = badlog("info", folder / log).out
            said shouldContain "MILLC Qualification 42"
            said shouldContain "format  Driver Station log"
        }
    }

    test("questions know link, power, enabled and messages of a Driver Station log") {
        inFolder { folder ->
            folder.pair()
            val signals = badlog("info", folder / log, "--signals").out
            for (topic in listOf("Comms Connected", "Battery Voltage", "Enabled", "Robot Mode", "Trip Time", "Packet Loss", "Brownout", "Console")) {
                signals shouldContain topic
            }
            signals shouldContain "PDP/Channel 0"
            signals shouldNotContain "PDP/Bus Voltage"
            badlog("find", folder, "any(brownout)", "--no-cache").out shouldContain log
        }
    }

    test("rows made of it by default hold each of its samples, at its own time") {
        inFolder { folder ->
            // 829 times 0.02 s is a little more than 16.58 s.
            val bytes = TestDslog().apply { repeat(1500) { record(volts = 12.0 + it % 200 / 256.0, cpu = it % 100) } }.bytes
            val whole = readRecording(folder.with("long.dslog", bytes), LOG_FORMATS)
            for (format in listOf("bag", "csv")) {
                val ended = badlog("convert", folder / "long.dslog", "--to", format)
                ended.out shouldContain "1,500 rows"
                ended.out shouldNotContain "between"
                val rows = readRecording(folder / "long.$format", LOG_FORMATS)
                for (topic in whole.topics.filter { it.samples.isNotEmpty() }) {
                    rows.topics.single { topic.name in it.name }.samples.toList() shouldBe topic.samples.toList()
                }
            }
        }
    }

    test("a Driver Station's log becomes a WPILOG, rows, a part and a clean log") {
        inFolder { folder ->
            folder.pair()
            badlog("convert", folder / log, "--to", "wpilog")
            val whole = readRecording(folder / log, LOG_FORMATS)
            val written = readRecording(folder / log.replace(".dslog", ".wpilog"), LOG_FORMATS)
            written.topics.map { it.name } shouldContainAll whole.topics.map { it.name }
            badlog("convert", folder / log, "--to", "bag", "--period", "0.1")
            readRecording(folder / log.replace(".dslog", ".bag"), LOG_FORMATS).rowCount shouldBeGreaterThan 25
            badlog("cut", folder / log, "--enabled").out shouldContain "Sat.cut.wpilog"
            readRecording(folder / log.replace(".dslog", ".cut.wpilog"), LOG_FORMATS).isSalvaged shouldBe false
            val torn = folder.with("torn.dslog", STATION_LOG.bytes.let { it.copyOf(it.size - 5) })
            badlog("recover", torn)
            ("torn.recovered.wpilog" in folder.names()) shouldBe true
        }
    }
})
