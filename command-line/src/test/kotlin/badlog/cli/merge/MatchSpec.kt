package badlog.cli.merge

import badlog.cli.Ended
import badlog.cli.Logged
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import badlog.cli.with
import badlog.cli.wpilog
import badlog.files.inFolder
import badlog.formats.driverstation.STATION_START
import badlog.formats.driverstation.Status
import badlog.formats.driverstation.TestDslog
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.PropertyTesting
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.nio.file.Path
import java.util.zip.ZipEntry
import java.util.zip.ZipFile
import java.util.zip.ZipOutputStream
import kotlin.io.path.createDirectory
import kotlin.io.path.div
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.outputStream
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.random.Random

/** Enabled from 5 to 8 s and from 9 to 15 s of 17. */
private fun dslog() = TestDslog(start = STATION_START).records(250).records(150, Status.BOTH_AUTO).records(50).records(300, Status.BOTH_TELEOP).records(100)

/** A robot's log of that, whose clock began [later] than the Driver Station's log. */
private fun Path.robot(name: String, topic: String, later: Double) = wpilog(
    name,
    listOf(
        Logged("$topic/Robot Enabled", "boolean", "", listOf(0.0 to false, 5 - later to true, 8 - later to false, 9 - later to true, 15 - later to false, 16 - later to false)),
        Logged("/$topic/Angle", "double", "", List(20) { it / 2.0 + 0.5 to it.toDouble() }),
    ),
)

private fun zip(file: Path, vararg entries: Pair<String, ByteArray>): Path {
    ZipOutputStream(file.outputStream()).use { zip ->
        for ((name, bytes) in entries) {
            zip.putNextEntry(ZipEntry(name))
            zip.write(bytes)
            zip.closeEntry()
        }
    }
    return file
}

private fun JsonObject.topics() = getValue("topics").jsonArray.map { it.jsonObject.getValue("name").jsonPrimitive.content }

private fun Ended.oneLine() = (out + err).replace(Regex("\\s+"), " ")

class MatchSpec : FunSpec({
    test("a ZIP that merge writes opens as one match, for info, report and export, and so does its folder") {
        inFolder { folder ->
            val stations = (folder / "ds").createDirectory()
            stations.with("2026_03_07 10_04_05 Sat.dslog", dslog().bytes)
            val arm = folder.robot("arm.wpilog", "Arm", -10.0)
            val eye = folder.robot("eye.wpilog", "Eye", 2.0)
            badlog("merge", eye, arm, "--align", "enabled", "--with-ds=$stations", "-o", folder / "match.zip").code shouldBe ExitCode.WHOLE
            ZipFile((folder / "match.zip").toFile()).use { zip ->
                zip.getInputStream(zip.getEntry("arm.wpilog")).readBytes() shouldBe arm.readBytes()
                zip.getInputStream(zip.getEntry("match.json")).readBytes().decodeToString() shouldContain "\"role\":\"driver station\""
            }
            val json = badlogJson("info", folder / "match.zip").json.single()
            json.topics() shouldContain "/Arm/Angle"
            json.topics() shouldContain "eye/Eye/Angle"
            json.topics() shouldContain "Driver Station/Battery Voltage"
            val said = badlog("info", folder / "match.zip").oneLine()
            said shouldContain "Files/arm.wpilog robot: the clock of the match"
            said shouldContain "Files/eye.wpilog robot: moved by 12.0 s; as stated, within 0 ms"
            badlog("report", folder / "match.zip", "--no-cache").out shouldContain "match.zip"
            badlog("export", folder / "match.zip", "-o", folder / "page.html").code shouldBe ExitCode.WHOLE
            (folder / "page.html").readText() shouldContain "match.zip.wpilog"

            val unpacked = (folder / "unpacked").createDirectory()
            ZipFile((folder / "match.zip").toFile()).use { zip ->
                zip.entries().asSequence().forEach { unpacked.with(it.name, zip.getInputStream(it).readBytes()) }
            }
            badlogJson("info", unpacked).json.single().topics() shouldBe json.topics()
            // Without what states the clocks, they are found.
            (unpacked / "match.json").toFile().delete()
            val found = zip(folder / "found.zip", *unpacked.listDirectoryEntries().map { "Q3/${it.fileName}" to it.readBytes() }.toTypedArray())
            val sentence = badlog("info", found).oneLine()
            sentence shouldContain "4 edges of enabled fit"
            badlogJson("info", found).json.single().topics().size shouldBe json.topics().size
        }
    }

    test("--align, --offset and --with-ds give info and export what merge writes, in any order of the logs") {
        inFolder { folder ->
            val random = Random(12)
            val stations = (folder / "ds").createDirectory()
            stations.with("2026_03_07 10_04_05 Sat.dslog", dslog().bytes)
            val logs = listOf(folder.robot("arm.wpilog", "Arm", -10.0), folder.robot("eye.wpilog", "Eye", 2.0), folder.robot("leg.wpilog", "Leg", -1.0))
            val ways = listOf(
                logs to listOf("--align", "enabled"),
                logs to listOf("--offset", "eye.wpilog=3.5"),
                logs to listOf("--align", "enabled", "--with-ds=$stations"),
                logs.take(1) to listOf("--with-ds=$stations"),
            )
            repeat(maxOf(1, PropertyTesting.defaultIterationCount / 100)) { run ->
                for ((index, way) in ways.withIndex()) {
                    val (given, options) = way
                    val merged = folder / "merged$run-$index.wpilog"
                    badlog("merge", *given.shuffled(random).toTypedArray(), *options.toTypedArray(), "-o", merged).code shouldBe ExitCode.WHOLE
                    val expected = badlogJson("info", merged).json.single()
                    val info = badlogJson("info", *given.shuffled(random).toTypedArray(), *options.toTypedArray()).json.single()
                    withClue("$options") {
                        for (key in listOf("topics", "values", "x", "samples")) info[key] shouldBe expected[key]
                    }
                    val page = folder / "page$run-$index.html"
                    badlog("export", *given.shuffled(random).toTypedArray(), *options.toTypedArray(), "-o", page).code shouldBe ExitCode.WHOLE
                    page.readText().length shouldBeGreaterThan 1000
                    val report = badlogJson("report", *given.shuffled(random).toTypedArray(), *options.toTypedArray(), "--out", folder / "report$run-$index").json
                    report.size shouldBe 1
                }
            }
        }
    }

    test("what a ZIP must not hold is refused in a sentence, and writes nothing outside") {
        inFolder { folder ->
            val log = folder.robot("arm.wpilog", "Arm", 0.0).readBytes()
            fun said(vararg entries: Pair<String, ByteArray>): String {
                val ended = badlog("info", zip(folder / "hostile.zip", *entries))
                ended.code shouldBe ExitCode.NOTHING
                return ended.oneLine()
            }
            said("../arm.wpilog" to log) shouldContain "not the name of a file in a ZIP"
            said("/etc/arm.wpilog" to log) shouldContain "not the name of a file"
            said("C:arm.wpilog" to log, "b.wpilog" to log) shouldContain "not the name of a file"
            said("a.wpilog" to log, "A.wpilog" to log) shouldContain "two files called"
            said("a.wpilog" to ByteArray(8 shl 20)) shouldContain "grows more than 200 times"
            said("a.wpilog" to log, "match.json" to "{}".encodeToByteArray()) shouldContain "match.json cannot be read"
            said("a.wpilog" to log, "b.wpilog" to log) shouldContain "the logs of 2 matches"
            said("a.wpilog" to "%PDF-1.4".encodeToByteArray()) shouldContain "no robot's log that can be read"
            badlog("info", zip(folder / "texts.zip", "a.txt" to log)).oneLine() shouldContain "archive of files"
            folder.listDirectoryEntries().map { "${it.fileName}" }.sorted() shouldBe listOf("arm.wpilog", "hostile.zip", "texts.zip")
            (folder.parent / "arm.wpilog").exists() shouldBe false
        }
    }

    test("a damaged ZIP ends in a match or a sentence, never in a defect") {
        inFolder { folder ->
            val random = Random(99)
            val log = folder.robot("arm.wpilog", "Arm", 0.0).readBytes()
            val manifest = "{\"version\":1,\"files\":[{\"name\":\"arm.wpilog\",\"seconds\":0}]}".encodeToByteArray()
            val whole = zip(folder / "whole.zip", "match.json" to manifest, "arm.wpilog" to log, "ds/a.dslog" to dslog().bytes).readBytes()
            repeat(PropertyTesting.defaultIterationCount / 5) { run ->
                val bytes = whole.copyOf(if (run % 3 == 0) random.nextInt(4, whole.size) else whole.size)
                repeat(random.nextInt(1, 6)) { bytes[random.nextInt(4, bytes.size)] = random.nextInt().toByte() }
                val ended = badlog("info", folder.with("mutant.zip", bytes))
                (ended.out + ended.err).isNotEmpty() shouldBe true
            }
        }
    }

    test("a file that the ZIP lacks, or that does not fit, is a sentence in the log") {
        inFolder { folder ->
            val log = folder.robot("arm.wpilog", "Arm", 0.0).readBytes()
            val manifest = "{\"version\":1,\"files\":[{\"name\":\"arm.wpilog\"},{\"name\":\"rio.hoot\"}]}".encodeToByteArray()
            val said = badlog("info", zip(folder / "m.zip", "match.json" to manifest, "arm.wpilog" to log, "video.mp4" to ByteArray(9))).oneLine()
            said shouldContain "rio.hoot is missing, which match.json names."
            said shouldContain "The Driver Station's log is missing"
            said shouldContain "Files/video.mp4 video"
        }
    }
})
