package badlog.page

import badlog.exporter.EmptyPage
import badlog.formats.driverstation.Status
import badlog.formats.driverstation.TestDslog
import io.kotest.core.annotation.Tags
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.ByteArrayOutputStream
import java.nio.file.Files
import java.util.zip.CRC32
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream
import kotlin.io.path.createDirectories
import kotlin.io.path.div
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText

/** The logs of one match in a ZIP, or beside a `match.json`, on the page. */
@Tags("InCheck")
internal class MatchZipSpec : PageSpec({
    val folder by lazy { Files.createTempDirectory("badlog-match") }
    val page by lazy { (folder / EmptyPage.NAME).also { EmptyPage().write(it) } }

    afterSpec { folder.toFile().deleteRecursively() }

    /** A robot's log of a match that began [day] days after the first. */
    fun robot(day: Int = 0): ByteArray {
        val header = """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis","hide"]},{"name":"Robot/Enabled","unit":"ul","attrs":[]},""" +
            """{"name":"Arm/Angle","unit":"deg","attrs":[]}],"values":[{"name":"Start Time","value":"2026-03-0${7 + day} 15:04:08 UTC"}]}"""
        val rows = List(600) { row -> "${row / 50.0},${row in 100 until 250},${row % 90}" }
        return (listOf(header, "Time,Robot/Enabled,Arm/Angle") + rows).joinToString("\n", postfix = "\n").encodeToByteArray()
    }

    val station = TestDslog().records(250).records(150, Status.BOTH_TELEOP).records(450).bytes
    val log = "2026_03_07 10_04_05 Sat.dslog"

    fun zip(vararg files: Pair<String, ByteArray>, isStored: Boolean = false): ByteArray = ByteArrayOutputStream().also { out ->
        ZipOutputStream(out).use { zip ->
            for ((name, bytes) in files) {
                val entry = ZipEntry(name)
                if (isStored) {
                    entry.method = ZipEntry.STORED
                    entry.size = bytes.size.toLong()
                    entry.crc = CRC32().apply { update(bytes) }.value
                }
                zip.putNextEntry(entry)
                zip.write(bytes)
            }
        }
    }.toByteArray()

    fun OpenPage.topics() = texts("main .graph-title")

    browserTest("a ZIP of the logs of a match opens as one log") {
        onPage(page, state = "empty") {
            fun dropped(vararg files: Pair<String, ByteArray>, state: String = "ready") {
                drop(*files)
                await("another screen") { this.state != "empty" }
                awaitState(state)
            }

            fun back() {
                click("#go-back")
                awaitState("empty")
            }
            step("with the Driver Station's signals on the robot's clock, and what fits how") {
                dropped("match.zip" to zip("robot.bag" to robot(), log to station, "notes.txt" to byteArrayOf(1)))
                topics() shouldContainAll listOf("Angle", "Battery Voltage")
                text shouldContain "driver station: moved by"
                text shouldContain "edges of enabled fit"
                saved("match.zip.wpilog") { click("#download") }.decodeToString(0, 6) shouldBe "WPILOG"
                back()
            }
            step("also if nothing is packed, in a folder, or beside a match.json that states its clock") {
                val manifest = """{"version":1,"files":[{"name":"robot.bag"},{"name":"$log","seconds":1.5},{"name":"lost.bag"}]}""".encodeToByteArray()
                val files = arrayOf("robot.bag" to robot(), log to station, "match.json" to manifest)
                dropped("match.zip" to zip(*files.map { (name, bytes) -> "Q7/$name" to bytes }.toTypedArray(), isStored = true))
                text shouldContain "moved by 1.5 s; as stated"
                text shouldContain "lost.bag is missing"
                back()
                dropped(*files)
                text shouldContain "moved by 1.5 s; as stated"
                back()
            }
            step("also without a ZIP, if one robot's log and those of other devices are dropped together") {
                dropped("robot.bag" to robot(), log to station)
                text shouldContain "edges of enabled fit"
                back()
            }
            step("of a dropped folder with a match.json, the match is opened, also on the way forward after back") {
                val manifest = """{"version":1,"files":[{"name":"robot.bag"},{"name":"$log","seconds":2.5}]}"""
                val day = (folder / "Q7").createDirectories()
                (day / "robot.bag").writeBytes(robot())
                (day / log).writeBytes(station)
                (day / "match.json").writeText(manifest)
                drop(day)
                repeat(2) {
                    await("the match") { "moved by 2.5 s; as stated" in text }
                    awaitState("ready")
                    driver.navigate().back()
                    awaitState("empty")
                    if (it == 0) driver.navigate().forward()
                }
            }
            step("files of another program's match.json are listed, and a mistake in one is said") {
                dropped("robot.bag" to robot(), "match.json" to "{}".encodeToByteArray())
                texts(".page-title h1") shouldBe listOf("robot.bag")
                back()
                val newer = "match.json" to """{"version":2,"files":[]}""".encodeToByteArray()
                dropped("match.zip" to zip("robot.bag" to robot(), newer), state = "failed")
                text shouldContain "is from a newer badlog"
                back()
            }
            step("a log that pages do not read is left out, and one beside the folder of the match.json is another") {
                val manifest = """{"version":1,"files":[{"name":"robot.bag"},{"name":"rio.hoot"}]}""".encodeToByteArray()
                val files = listOf("Q7/robot.bag" to robot(), "Q7/rio.hoot" to ByteArray(9), "Q7/match.json" to manifest, "notes.csv" to byteArrayOf(1))
                dropped("match.zip" to zip(*files.toTypedArray()))
                text shouldContain "rio.hoot is left out"
                text shouldContain "../notes.csv"
                back()
            }
            step("of two matches, the logs can be listed") {
                dropped("day.zip" to zip("a/robot.bag" to robot(), "b/robot.bag" to robot(day = 1)), state = "failed")
                text shouldContain "It has the logs of 2 matches"
                click("#list-logs")
                awaitState("empty")
                listedLogs.size shouldBe 2
                back()
            }
            step("what is no ZIP, damaged, or grows without end is refused") {
                val good = zip("robot.bag" to robot())
                val damaged = good.copyOf().also { it[good.size / 2] = (it[good.size / 2] + 1).toByte() }
                val bomb = zip("robot.csv" to ByteArray(70_000_000))
                val stored = zip("robot.bag" to robot(), isStored = true).also { it[2000] = (it[2000] + 1).toByte() }
                val list = good.copyOf().also { it[good.size - 77] = 0 }
                for ((bytes, sentence) in listOf(
                    byteArrayOf(1, 2, 3) to "not a ZIP",
                    list to "not a ZIP",
                    damaged to "damaged",
                    stored to "damaged",
                    bomb to "grows more than 200 times",
                )) {
                    dropped("match.zip" to bytes, state = "failed")
                    text shouldContain sentence
                    back()
                }
            }
        }
    }
})
