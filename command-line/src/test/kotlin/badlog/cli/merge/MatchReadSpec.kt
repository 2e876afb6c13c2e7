package badlog.cli.merge

import badlog.catalog.match.MatchMaker
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
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Path
import java.util.zip.ZipFile
import kotlin.io.path.createDirectory
import kotlin.io.path.div
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.readBytes
import kotlin.io.path.readText

/** A ZIP or folder of a match, read as one log. */
class MatchReadSpec : FunSpec({
    test("a ZIP that merge writes opens as one match, for info, report and export, and so does its folder") {
        inFolder { folder ->
            val stations = (folder / "ds").createDirectory()
            stations.with("2026_03_07 10_04_05 Sat.dslog", stationLog().bytes)
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
            day.with("a.dslog", stationLog().bytes)
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
            val commands = listOf<List<Any>>(listOf("info"), listOf("report"), listOf("report"), listOf("export", "-o", folder / "p.html"), listOf("merge", "-o", folder / "m.wpilog"), listOf("convert", "-o", folder / "m.bag")) +
                List(2) { listOf("find", "max(Angle)") }
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

    test("convert writes one log of a ZIP, or of a folder with a match.json, named after it") {
        inFolder { folder ->
            val day = (folder / "day").createDirectory()
            val entries = listOf("arm.wpilog" to day.robot("arm.wpilog", "Arm", 0.0).readBytes(), "a.dslog" to day.with("a.dslog", stationLog().bytes).readBytes()) +
                ("match.json" to day.with("match.json", "{\"version\":1,\"files\":[{\"name\":\"arm.wpilog\"},{\"name\":\"a.dslog\",\"seconds\":0}]}").readBytes())
            val zipped = zip(folder / "q12.zip", *entries.toTypedArray())
            val expected = badlogJson("info", zipped).json.single()
            badlog("convert", zipped, "--to", "wpilog").code shouldBe ExitCode.WHOLE
            for (key in listOf("topics", "values", "x", "samples")) badlogJson("info", folder / "q12.wpilog").json.single()[key] shouldBe expected[key]
            badlog("convert", day, "--out", folder / "day.wpilog").code shouldBe ExitCode.WHOLE
            (folder / "day.wpilog").readBytes() shouldBe (folder / "q12.wpilog").readBytes()
            // What falls between two rows is left out, as of a WPILOG.
            badlog("convert", zipped, "--to", "csv", "--only", "*Angle").oneLine() shouldContain "q12.csv"
            (folder / "q12.csv").readText() shouldContain "/Arm/Angle"
            badlog("convert", zipped, "--to", "parquet").code shouldBe ExitCode.WHOLE
            folder.listDirectoryEntries("q12.*").map { "${it.fileName}" }.sorted() shouldBe listOf("q12.csv", "q12.parquet", "q12.wpilog", "q12.zip")
            badlog("convert", zipped, "--to", "bag", "--out", zipped, "--force").code shouldBe ExitCode.NOTHING
        }
    }

    test("find, sql and lake read a ZIP, or a folder with a match.json, as one log, and again if one of its files changed") {
        inFolder { folder ->
            val day = (folder / "day").createDirectory()
            val log = day.robot("arm.wpilog", "Arm", 0.0)
            day.with("a.dslog", stationLog().bytes)
            day.with("match.json", "{\"version\":1,\"files\":[{\"name\":\"arm.wpilog\"},{\"name\":\"a.dslog\",\"seconds\":0}]}")
            val zipped = zip(folder / "q12.zip", "arm_Q12.wpilog" to log.readBytes(), "a.dslog" to stationLog().bytes)
            for (match in listOf(zipped, day)) {
                val found = badlog("find", match, "max(\"Driver Station/Battery Voltage\") + max(\"/Arm/Angle\") > 19")
                withClue(found.oneLine()) { found.oneLine() shouldContain "Found in 1 of 1 log." }
                badlog("lake", match, "--out", folder / "lake-${match.fileName}").oneLine() shouldContain "1 log written"
                badlog("lake", match, "--out", folder / "lake-${match.fileName}").oneLine() shouldContain "1 unchanged"
                badlog("sql", match, "SELECT count(*) AS logs FROM matches", "--csv").out shouldBe "logs\n1\n"
            }
            day.wpilog("arm.wpilog", listOf(Logged("/Arm/Angle", "double", "", List(20) { it / 2.0 to 90.0 })))
            badlog("find", day, "max(\"/Arm/Angle\") > 80").oneLine() shouldContain "Found in 1 of 1 log."
            badlog("lake", day, "--out", folder / "lake-day").oneLine() shouldContain "1 log written"
        }
    }

    test("empty cells of a table in a ZIP count as little as in the table") {
        inFolder { folder ->
            val names = listOf("Enabled", "Often", "Seldom", "State")
            val topics = names.joinToString("") { ",{\"name\":\"$it\"}" }
            val rows = (0 until 300).joinToString("") { "${it / 10.0},${it in 50..250},${if (it % 3 == 0) "" else "$it"},${if (it % 9 == 0) "$it" else ""},${if (it % 30 == 0) "up" else ""}\n" }
            val bag = folder.with("arm.bag", "{\"topics\":[{\"name\":\"Time\",\"unit\":\"s\",\"attrs\":[\"xaxis\"]}$topics]}\nTime,${names.joinToString(",")}\n$rows")
            val zipped = zip(folder / "arm.zip", "arm.bag" to bag.readBytes())
            fun shown(log: Path) = badlogJson("info", log).json.single().getValue("topics").jsonArray.map { it.jsonObject }.associate { topic ->
                topic.getValue("name") to listOf("count", "texts", "min", "max", "rate").map { topic[it] }
            }
            shown(zipped) shouldBe shown(bag)
            for (question in listOf("count(Often)", "mean(Often)", "mean(Seldom)", "count(Seldom)", "count(State)")) {
                fun answer(log: Path) = badlogJson("find", log, question, "--no-cache").json.single().filterKeys { it != "file" && it != "match" && it != "title" }
                withClue(question) { answer(zipped) shouldBe answer(bag) }
            }
        }
    }
})
