package badlog.cli.merge

import badlog.catalog.match.MatchMaker
import badlog.cli.Ended
import badlog.cli.Logged
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import badlog.cli.with
import badlog.cli.wpilog
import badlog.files.ReadOptions
import badlog.files.inFolder
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import badlog.formats.driverstation.STATION_START
import badlog.formats.driverstation.Status
import badlog.formats.driverstation.TestDslog
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import io.kotest.property.PropertyTesting
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.double
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.nio.ByteBuffer
import java.nio.ByteOrder
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

/** A robot's log of that, with a clock that began [later] than the Driver Station's log. */
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
            val found = zip(folder / "found.zip", *unpacked.listDirectoryEntries().map { "Q3\\${"${it.fileName}".replace(".wpilog", "_Q3.wpilog")}" to it.readBytes() }.toTypedArray())
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
                    // What rules find, and where, is the same in what merge writes. With --with-ds alone, they use the robot's log as it is.
                    fun reported(vararg arguments: Any) = badlogJson("report", *arguments, "--no-cache").json.single().filterKeys { it != "file" && it != "driverStation" }
                    if (options.size > 1 || "--with-ds" !in options[0]) {
                        withClue("$options") { reported(*given.shuffled(random).toTypedArray(), *options.toTypedArray()) shouldBe reported(merged) }
                    }
                    val pages = folder / "report$run-$index"
                    badlog("report", *given.shuffled(random).toTypedArray(), *options.toTypedArray(), "--out", pages).code shouldBe ExitCode.WHOLE
                    pages.listDirectoryEntries("*.html").size shouldBe 2
                }
            }
        }
    }

    test("a ZIP of a log shows the same as the log: types of structs, poses, and sizes instead of values") {
        inFolder { folder ->
            fun bytes(vararg numbers: Double) = ByteBuffer.allocate(numbers.size * 8).order(ByteOrder.LITTLE_ENDIAN).also { all -> numbers.forEach { all.putDouble(it) } }.array()
            val log = folder.wpilog(
                "arm.wpilog",
                listOf(
                    Logged("/.schema/struct:Translation2d", "structschema", "", listOf(0.0 to "double x;double y")),
                    Logged("/.schema/struct:Rotation2d", "structschema", "", listOf(0.0 to "double value")),
                    Logged("/.schema/struct:Pose2d", "structschema", "", listOf(0.0 to "Translation2d translation;Rotation2d rotation")),
                    Logged("/.schema/struct:Transform2d", "structschema", "", listOf(0.0 to "Translation2d translation;Rotation2d rotation")),
                    Logged("/Drive/Target", "struct:Translation2d", "", List(5) { it * 1.0 to bytes(it * 1.0, 2.0) }),
                    Logged("/Drive/Pose", "struct:Pose2d", "", List(5) { it * 1.0 to bytes(it * 1.0, 2.0, 0.5) }),
                    Logged("/Camera/Transform", "struct:Transform2d", "", List(5) { it * 1.0 to bytes(it * 1.0, 2.0, 0.5) }),
                    Logged("NT:/FMSInfo/MatchNumber", "raw", "", listOf(1.0 to ByteArray(8))),
                ),
            )
            val zipped = zip(folder / "arm.zip", "arm.wpilog" to log.readBytes())
            fun typesIn(file: Path) = readRecording(file, LOG_FORMATS, ReadOptions(maker = MatchMaker)).topics.map { Triple(it.name, it.type, it.unit) }.toSet()
            typesIn(zipped) shouldBe typesIn(log)
            val (own, others) = listOf(log, zipped).map { badlogJson("info", it).json.single() }
            for (key in listOf("match", "signals", "topics")) own[key] shouldBe others[key]
            val (found, alike) = listOf(log, zipped).map { file -> badlogJson("report", file, "--no-cache").json.single() }
            found["findings"] shouldBe alike["findings"]
            badlog("info", zipped, "--problems").oneLine() shouldContain "not decoded have only their sizes here"
            badlog("merge", zipped, "-o", folder / "all.wpilog").oneLine() shouldContain "undecoded bytes"
        }
    }

    test("a ZIP that would not open as one match is not written") {
        inFolder { folder ->
            // A program that was started again.
            val (one, two) = folder.robot("first.wpilog", "Arm", 0.0) to folder.robot("second.wpilog", "Arm", 0.0)
            val ended = badlog("merge", one, two, "-o", folder / "m.zip")
            ended.code shouldBe ExitCode.NOTHING
            ended.oneLine() shouldContain "use --align enabled, or --offset $two=SECONDS"
            (folder / "m.zip").exists() shouldBe false
            badlog("merge", one, two, "--offset", "second.wpilog=40", "-o", folder / "m.zip").code shouldBe ExitCode.WHOLE
            badlog("info", folder / "m.zip").code shouldBe ExitCode.WHOLE
        }
    }

    test("a Driver Station's log that is given and found is there once; a place that is given counts") {
        inFolder { folder ->
            folder.robot("robot.wpilog", "Arm", 2.0)
            folder.with("2026_03_07 10_04_05 Sat.dslog", dslog().bytes)
            val alone = badlogJson("merge", folder / "robot.wpilog", "--with-ds", "-o", folder / "alone.out").json.single()
            val both = badlogJson("merge", folder, "--with-ds", "-o", folder / "both.out").json.single()
            both["samples"] shouldBe alone["samples"]
            both["moved"] shouldBe alone["moved"]
            val given = badlogJson("merge", folder, "--with-ds", "--offset", "2026_03_07 10_04_05 Sat.dslog=1.5", "-o", folder / "given.out").json.single()
            given.getValue("moved").jsonArray.map { it.jsonObject.getValue("seconds").jsonPrimitive.double } shouldBe listOf(1.5)
            badlog("merge", folder, "--with-ds", "-o", folder / "m.zip").code shouldBe ExitCode.WHOLE
            badlog("info", folder / "m.zip").code shouldBe ExitCode.WHOLE
        }
    }

    test("a ZIP with forbidden content is refused in a sentence, and writes nothing outside") {
        inFolder { folder ->
            val log = folder.robot("arm.wpilog", "Arm", 0.0).readBytes()
            fun said(vararg entries: Pair<String, ByteArray>): String {
                val ended = badlog("info", zip(folder / "hostile.zip", *entries))
                ended.code shouldBe ExitCode.NOTHING
                return ended.oneLine()
            }
            said("../arm.wpilog" to log) shouldContain "not the name of a file on every system"
            said("/etc/arm.wpilog" to log) shouldContain "not the name of a file"
            said("C:arm.wpilog" to log, "b.wpilog" to log) shouldContain "not the name of a file"
            said("a.wpilog" to log, "A.wpilog" to log) shouldContain "are one name on some systems"
            said("a.wpilog" to ByteArray(65 shl 20)) shouldContain "grows more than 200 times"
            said("a.wpilog" to log, "match.json" to "{\"version\":1,\"files\":[3]}".encodeToByteArray()) shouldContain "match.json cannot be read"
            said("a.wpilog" to log, "b.wpilog" to log) shouldContain "the logs of 2 matches"
            said("a.wpilog" to "%PDF-1.4".encodeToByteArray()) shouldContain "no robot's log that can be read"
            badlog("info", zip(folder / "texts.zip", "a.txt" to log)).oneLine() shouldContain "archive of files"
            folder.listDirectoryEntries().map { "${it.fileName}" }.sorted() shouldBe listOf("arm.wpilog", "hostile.zip", "texts.zip")
            (folder.parent / "arm.wpilog").exists() shouldBe false
        }
    }

    test("a truncated ZIP is refused in a sentence") {
        inFolder { folder ->
            val whole = zip(folder / "whole.zip", "arm.wpilog" to folder.robot("arm.wpilog", "Arm", 0.0).readBytes()).readBytes()
            val ended = badlog("info", folder.with("cut.zip", whole.copyOf(whole.size / 2)))
            ended.code shouldBe ExitCode.NOTHING
            ended.oneLine() shouldContain "not a ZIP that can be read; make it again."
        }
    }

    test("a file that the ZIP lacks, or that does not fit, is a sentence in the log") {
        inFolder { folder ->
            val log = folder.robot("arm.wpilog", "Arm", 0.0).readBytes()
            val manifest = "{\"version\":1,\"files\":[{\"name\":\"arm.wpilog\"},{\"name\":\"rio.hoot\"}]}".encodeToByteArray()
            val said = badlog("info", zip(folder / "m.zip", "match.json" to manifest, "arm.wpilog" to log, "video.mp4" to ByteArray(9), "list.csv" to "Name,Team\nA,B\n".encodeToByteArray())).oneLine()
            said shouldContain "rio.hoot is missing, which match.json names."
            said shouldContain "The Driver Station's log is missing"
            said shouldContain "list.csv has no samples over time"
            // A video is not part of a log; export --video shows one.
            said shouldNotContain "video.mp4"
        }
    }

    test("match.json in a folder of a whole day is the match of the files that it names; the others are logs of their own") {
        inFolder { folder ->
            val day = (folder / "day").createDirectory()
            day.robot("arm.wpilog", "Arm", 0.0)
            day.with("a.dslog", dslog().bytes)
            day.robot("Q4.wpilog", "Eye", 2.0)
            day.with("match.json", "{\"version\":1,\"files\":[{\"name\":\"arm.wpilog\"},{\"name\":\"a.dslog\",\"seconds\":0},{\"name\":\"rio.hoot\"}]}")
            val (match, other) = badlogJson("info", day).json
            match.topics() shouldContain "Driver Station/Battery Voltage"
            match.topics() shouldNotContain "eye/Eye/Angle"
            "$match" shouldContain "rio.hoot is missing"
            "${other["file"]}" shouldContain "Q4.wpilog"
            day.with("match.json", "{\"version\":1,\"files\":[")
            val broken = badlog("info", day)
            broken.code shouldBe ExitCode.SALVAGED
            broken.oneLine() shouldContain "match.json cannot be read"
            badlogJson("info", day).json.size shouldBe 4
        }
    }

    test("a match.json of another program is ignored, in a folder or a ZIP") {
        inFolder { folder ->
            val day = (folder / "day").createDirectory()
            val log = day.robot("arm.wpilog", "Arm", 0.0)
            val foreign = "{\"key\":\"2026test_qm4\",\"alliances\":{\"red\":{\"score\":3}}}"
            day.with("match.json", foreign)
            for (command in listOf<List<Any>>(listOf("info"), listOf("report", "--no-cache"), listOf("merge", day.robot("eye.wpilog", "Eye", 0.0), "-o", folder / "m.wpilog"))) {
                val ended = badlog(command[0], day, *command.drop(1).toTypedArray())
                withClue(command) { ended.code shouldBe ExitCode.WHOLE }
                ended.oneLine() shouldNotContain "match.json"
            }
            val zipped = zip(folder / "m.zip", "match.json" to foreign.encodeToByteArray(), "arm.wpilog" to log.readBytes())
            badlog("info", zipped).code shouldBe ExitCode.WHOLE
        }
    }

    test("a match without one of its logs is incomplete, and every command says so") {
        inFolder { folder ->
            val log = folder.robot("arm.wpilog", "Arm", 0.0).readBytes()
            val match = zip(folder / "m.zip", "arm.wpilog" to log, "list.csv" to "Name,Team\nA,B\n".encodeToByteArray())
            val sentence = "list.csv has no samples over time, so it cannot be placed."
            // Twice, since the second report may know the first one's results.
            val commands = listOf<List<Any>>(listOf("info"), listOf("report"), listOf("report"), listOf("export", "-o", folder / "p.html"), listOf("merge", "-o", folder / "m.wpilog"))
            for (command in commands) {
                val ended = badlog(command[0], match, *command.drop(1).toTypedArray())
                withClue(command) {
                    ended.code shouldBe ExitCode.SALVAGED
                    ended.oneLine() shouldContain sentence
                }
            }
            for (command in commands.take(2)) "${badlogJson(command[0], match).json.single()}" shouldContain sentence
            // That no Driver Station's log is there is nothing lost.
            badlog("report", zip(folder / "whole.zip", "arm.wpilog" to log)).code shouldBe ExitCode.WHOLE
        }
    }

    test("merge never overwrites a log that it reads: of a match.json, one of its folder, a second file, or a Driver Station's that it searches") {
        inFolder { folder ->
            val day = (folder / "day").createDirectory()
            val robots = (day / "robots").createDirectory()
            val logs = listOf(robots.robot("r.wpilog", "Arm", 0.0), robots.robot("e.dat", "Eye", 0.0))
            day.with("match.json", "{\"version\":1,\"files\":[{\"name\":\"robots/r.wpilog\",\"seconds\":0},{\"name\":\"robots/e.dat\",\"seconds\":1}]}")
            val stations = (folder / "ds").createDirectory()
            val station = stations.with("2026_03_07 10_04_05 Sat.dslog", dslog().bytes)
            val events = stations.with("2026_03_07 10_04_05 Sat.dsevents", ByteArray(20))
            val robot = folder.robot("robot.wpilog", "Arm", 0.0)
            val beside = stations.robot("beside.wpilog", "Arm", 0.0)
            val tried = logs.flatMap { log -> listOf(day / "match.json", day).map { listOf<Any>("merge", it, "-o", log) } } +
                listOf(station, events).flatMap { log ->
                    listOf<List<Any>>(
                        listOf("merge", robot, "--with-ds=$stations", "-o", log),
                        listOf("merge", beside, "--with-ds", "-o", log),
                        listOf("export", robot, "--with-ds=$stations", "-o", log),
                    )
                } + listOf(listOf<Any>("merge", day, robot, "-o", day / "match.json"))
            val before = (logs + listOf(station, events, day / "match.json")).associateWith { it.readBytes().toList() }
            for (arguments in tried) {
                val ended = badlog(*arguments.toTypedArray(), "--force")
                withClue(arguments) {
                    ended.code shouldBe ExitCode.NOTHING
                    ended.oneLine() shouldContain "would overwrite a file that is read"
                    before.keys.associateWith { it.readBytes().toList() } shouldBe before
                }
            }
        }
    }

    fun stated(zip: Path): Map<String, Double?> = ZipFile(zip.toFile()).use { file ->
        val text = file.getInputStream(file.getEntry("match.json")).readBytes().decodeToString()
        Json.parseToJsonElement(text).jsonObject.getValue("files").jsonArray.map { it.jsonObject }
            .associate { it.getValue("name").jsonPrimitive.content to it["seconds"]?.jsonPrimitive?.double }
    }

    test("a ZIP states only clocks that are given or found, and the others are found when it is read") {
        inFolder { folder ->
            // On clocks that are 12 s apart, as only their moments of enabling show.
            val logs = listOf(folder.robot("arm_Q3.wpilog", "Arm", -10.0), folder.robot("eye_Q3.wpilog", "Eye", 2.0))
            val zip = folder / "m.zip"
            val ended = badlog("merge", *logs.toTypedArray(), "-o", zip)
            ended.oneLine() shouldContain "open: ${logs[1]}; its clock is found when the ZIP is read"
            stated(zip) shouldBe mapOf("arm_Q3.wpilog" to 0.0, "eye_Q3.wpilog" to null)
            badlog("info", zip).oneLine() shouldContain "Files/eye_Q3.wpilog robot: moved by 12.0 s; 4 edges of enabled fit"
            badlog("merge", *logs.toTypedArray(), "--offset", "eye_Q3.wpilog=0", "-o", zip, "--force").oneLine() shouldNotContain "open:"
            stated(zip) shouldBe mapOf("arm_Q3.wpilog" to 0.0, "eye_Q3.wpilog" to 0.0)
        }
    }

    test("a ZIP has the clock of the robot's log that began first, so that no sample is before 0") {
        inFolder { folder ->
            val (arm, eye) = folder.robot("arm.wpilog", "Arm", 0.0) to folder.robot("eye.wpilog", "Eye", 0.0)
            val zip = folder / "m.zip"
            badlog("merge", arm, eye, "--offset", "arm.wpilog=4", "-o", zip).code shouldBe ExitCode.WHOLE
            stated(zip) shouldBe mapOf("arm.wpilog" to 4.0, "eye.wpilog" to 0.0)
            badlog("merge", arm, eye, "--align", "enabled", "--offset", "arm.wpilog=4", "-o", zip, "--force").code shouldBe ExitCode.WHOLE
            stated(zip).values.toSet() shouldBe setOf(0.0)
            val late = folder.robot("late.wpilog", "Leg", 3.0)
            badlog("merge", eye, late, "--align", "enabled", "-o", zip, "--force").code shouldBe ExitCode.WHOLE
            stated(zip) shouldBe mapOf("eye.wpilog" to 0.0, "late.wpilog" to 3.0)
            val early = folder.robot("zoo.wpilog", "Zoo", -3.0)
            badlog("merge", eye, early, "--align", "enabled", "-o", zip, "--force").code shouldBe ExitCode.WHOLE
            stated(zip) shouldBe mapOf("eye.wpilog" to 3.0, "zoo.wpilog" to 0.0)
            badlog("info", zip).oneLine() shouldNotContain "left out"
        }
    }

    test("logs without an x axis are appended in the order given, not by name") {
        inFolder { folder ->
            val logs = listOf(folder.with("b.csv", "Motor,Amps\n1,2\n"), folder.with("a.csv", "Motor,Amps\n3,4\n"), folder.with("c.csv", "Motor,Amps\n5,6\n"))
            for (order in listOf(logs, logs.reversed())) {
                val merged = folder / "all.csv"
                badlog("merge", *order.toTypedArray(), "-o", merged, "--force").oneLine() shouldContain "in the order given: ${order[0]}"
                merged.readText() shouldBe "Motor,Amps\n" + order.joinToString("") { it.readText().substringAfter('\n') }
            }
        }
    }

    test("a log without the name of a log is opened in the ZIP that merge writes") {
        inFolder { folder ->
            val arm = folder.robot("arm.wpilog", "Arm", 0.0)
            val ended = badlog("merge", arm, folder.robot("robot", "Leg", 0.0), "--align", "enabled", "-o", folder / "m.zip")
            ended.code shouldBe ExitCode.WHOLE
            badlogJson("info", folder / "m.zip").json.single().topics() shouldContain "robot/Leg/Angle"
        }
    }

    test("merge reads a ZIP of a match, beside other logs or alone, and makes no ZIP of it") {
        inFolder { folder ->
            val (arm, eye) = folder.robot("arm.wpilog", "Arm", -10.0) to folder.robot("eye.wpilog", "Eye", 2.0)
            badlog("merge", arm, eye, "--align", "enabled", "-o", folder / "match.zip").code shouldBe ExitCode.WHOLE
            val alone = badlog("merge", folder / "match.zip", "-o", folder / "alone.wpilog")
            alone.code shouldBe ExitCode.WHOLE
            val expected = badlogJson("info", folder / "match.zip").json.single()
            badlogJson("info", folder / "alone.wpilog").json.single().topics() shouldBe expected.topics()
            folder.robot("leg.wpilog", "Leg", -1.0)
            val json = badlogJson("merge", folder / "match.zip", folder / "leg.wpilog", "--align", "enabled", "-o", folder / "all.wpilog").json.single()
            json.getValue("moved").jsonArray.size shouldBe 1
            badlogJson("info", folder / "all.wpilog").json.single().topics() shouldContain "/Leg/Angle"
            badlog("merge", folder / "match.zip", folder / "leg.wpilog", "-o", folder / "more.zip").oneLine() shouldContain "name them to make one ZIP"
            badlog("info", folder / "match.zip", "--with-ds").oneLine() shouldContain "--with-ds has no effect on a ZIP"
        }
    }

    test("a ZIP takes no option that changes logs, and needs a robot's log") {
        inFolder { folder ->
            val log = folder.robot("arm.wpilog", "Arm", 0.0)
            for (option in listOf(listOf("--append"), listOf("--join"), listOf("--x", "Time"))) {
                badlog("merge", log, folder.robot("eye.wpilog", "Eye", 0.0), *option.toTypedArray(), "-o", folder / "m.zip").run {
                    code shouldBe ExitCode.USAGE
                    oneLine() shouldContain "A ZIP has the logs as they are"
                }
            }
            val stations = listOf("a.dslog", "b.dslog").map { folder.with(it, dslog().bytes) }
            badlog("merge", *stations.toTypedArray(), "-o", folder / "m.zip").oneLine() shouldContain "needs a robot's log"
            (folder / "m.zip").exists() shouldBe false
        }
    }

    test("a log that cannot be read is reported, and the others are read without it") {
        inFolder { folder ->
            val log = folder.robot("arm.wpilog", "Arm", 0.0)
            val broken = folder.with("broken.wpilog", "%PDF-1.4")
            for (command in listOf(listOf("info"), listOf("report", "--no-cache"), listOf("export", "-o", folder / "p.html", "--force"))) {
                val ended = badlog(command[0], log, broken, folder.robot("eye.wpilog", "Eye", 0.0), "--align", "enabled", *command.drop(1).toTypedArray())
                ended.code shouldBe ExitCode.SALVAGED
                ended.oneLine() shouldContain "broken.wpilog"
            }
        }
    }

    test("info with --with-ds searches beside the robot's log, says how its clock was found, and accepts no log just because it is the only one") {
        inFolder { folder ->
            val stations = (folder / "robot").createDirectory()
            stations.with("2026_03_07 10_04_05 Sat.dslog", dslog().bytes)
            val cameras = (folder / "camera").createDirectory()
            val camera = cameras.wpilog("aaa.wpilog", listOf(Logged("/Camera/Angle", "double", "", List(5) { it * 1.0 to 1.0 })))
            val robot = stations.robot("robot.wpilog", "Arm", 0.0)
            badlog("merge", camera, robot, "--with-ds", "-o", folder / "m.wpilog").oneLine() shouldContain "4 edges of enabled fit"
            badlog("info", camera, robot, "--offset", "aaa.wpilog=1", "--with-ds").oneLine() shouldContain "aaa.wpilog by 1 s"

            val other = (folder / "other").createDirectory()
            other.with("2026_03_07 10_04_05 Sat.dslog", TestDslog(start = STATION_START).records(100).records(30, Status.BOTH_AUTO).records(100).bytes)
            for (command in listOf("info", "report")) {
                val ended = badlog(command, robot, "--with-ds=$other", "--json").json.single()
                "$ended" shouldNotContain "Driver Station/Battery Voltage"
                "$ended" shouldNotContain "driverStation"
            }
            val sentence = "robot.wpilog: no Driver Station log of its match was found, so it is shown as it is."
            badlog("info", robot, "--with-ds=$other").oneLine() shouldContain sentence
            badlog("export", robot, "--with-ds=$other", "-o", folder / "p.html").oneLine() shouldContain sentence
            badlog("info", robot, "--with-ds").oneLine() shouldNotContain "no Driver Station log"
        }
    }

    test("a robot's log that is named after the time and is moved makes a ZIP with a Driver Station's log whose clock is open") {
        inFolder { folder ->
            val robot = folder.robot("FRC_20260307_150405.wpilog", "Arm", 0.0)
            val station = folder.with("2026_03_07 10_04_05 Sat.dslog", dslog().bytes)
            val ended = badlog("merge", robot, station, "--offset", "${robot.fileName}=10", "-o", folder / "m.zip")
            withClue(ended.oneLine()) { ended.code shouldBe ExitCode.WHOLE }
            badlogJson("info", folder / "m.zip").json.single().topics() shouldContain "Driver Station/Battery Voltage"
        }
    }

    test("samples of the Driver Station's log before the robot's 0 are said to be left out, also in JSON") {
        inFolder { folder ->
            val robot = folder.robot("arm.wpilog", "Arm", 2.0)
            val stations = (folder / "ds").createDirectory()
            stations.with("2026_03_07 10_04_05 Sat.dslog", dslog().bytes)
            for (command in listOf(listOf("info"), listOf("export", "-o", folder / "p.html", "--force"))) {
                for (json in listOf(emptyList(), listOf("--json"))) {
                    val ended = badlog(command[0], robot, "--with-ds=$stations", *command.drop(1).toTypedArray(), *json.toTypedArray())
                    withClue("$command $json") { ended.err.replace(Regex("\\s+"), " ") shouldContain Regex("without [\\d,]+ samples before 0") }
                }
            }
        }
    }

    test("a merge reports doubt and damage, also in JSON: a single matching edge, and data lost in the Driver Station's log") {
        inFolder { folder ->
            fun enabled(name: String, late: Double) = folder.wpilog(name, listOf(Logged("$name/Robot Enabled", "boolean", "", listOf(late to false, late + 4 to true, late + 5 to true)), Logged("$name/a", "double", "", listOf(late to 1.0))))
            val (one, two) = enabled("one.wpilog", 0.0) to enabled("two.wpilog", 7.0)
            for (json in listOf(emptyList(), listOf("--json"))) {
                val ended = badlog("info", one, two, "--align", "enabled", *json.toTypedArray())
                ended.err.replace(Regex("\\s+"), " ") shouldContain "one edge of enabled fits, which may be chance"
            }
            val stations = (folder / "ds").createDirectory()
            stations.with("2026_03_07 10_04_05 Sat.dslog", dslog().bytes.let { it.copyOf(it.size - 3) })
            badlog("info", folder.robot("arm.wpilog", "Arm", 0.0), "--with-ds=$stations", "--problems").run {
                code shouldBe ExitCode.SALVAGED
                oneLine() shouldContain "record"
            }
        }
    }
})
