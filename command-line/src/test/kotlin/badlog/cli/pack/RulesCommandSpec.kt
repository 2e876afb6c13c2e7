package badlog.cli.pack

import badlog.cli.Logged
import badlog.cli.SAMPLES
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import badlog.cli.names
import badlog.cli.with
import badlog.cli.wpilog
import badlog.exporter.additionsIn
import badlog.files.inFolder
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import kotlinx.serialization.json.int
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream
import kotlin.io.path.div
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.readText

private const val HEADER = """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"Speed"}],"values":[]}"""

/** A bag of 60 s with speed 1, but 9 at 30 s. */
private val SLOW = HEADER + "\nTime,Speed\n" + (0..600).joinToString("") { "${it / 10.0},${if (it in 298..302) 9 else 1}\n" }

private const val RULE = "[[rule]]\nname='Fast'\nseverity='warning'\nwhen='Speed > 5'\ntext='It was fast at {time}.'\n"

private fun zip(folder: Path, target: Path): Path = target.also {
    ZipOutputStream(Files.newOutputStream(target)).use { out ->
        Files.walk(folder).use { all -> all.filter(Files::isRegularFile).toList() }.forEach { file ->
            out.putNextEntry(ZipEntry(folder.relativize(file).joinToString("/")))
            out.write(Files.readAllBytes(file))
            out.closeEntry()
        }
    }
}

class RulesCommandSpec : FunSpec({
    test("a pack begun from a moment of a log passes its own check, as folder and as zip") {
        inFolder { folder ->
            val log = folder.with("q42.bag", SLOW)
            val begun = badlog("rules", "new", folder / "ours", "--from", log, "--at", "30", "--name", "Too fast: 5 m/s")
            begun.code shouldBe ExitCode.WHOLE
            begun.out shouldContain "kept 20 s to 40 s"
            begun.out shouldContain "began the rule “Too fast: 5 m/s”: \"Speed\" > 5"
            val pack = folder / "ours.badlog-rules"
            (pack / "fires/Too fast_ 5 m_s").names() shouldBe listOf("q42 at 30 s.bag")
            badlog("rules", "new", pack, "--from", log, "--at", "0:50", "--name", "Too fast: 5 m/s", "--silent").code shouldBe ExitCode.WHOLE
            val checked = badlog("rules", "check", folder / "ours")
            checked.code shouldBe ExitCode.WHOLE
            checked.out shouldContain "1 rule, 2 slices: all slices pass."
            badlog("rules", "check", zip(pack, folder / "ours.zip")).out shouldBe checked.out
            pack.names() shouldBe listOf("badlog-rules.toml", "fires", "silent")
        }
    }

    test("failing slices are reported with the reason, and so are rules without slices") {
        inFolder { folder ->
            val pack = folder / "p"
            pack.with("badlog-rules.toml", RULE + RULE.replace("Fast", "Warm").replace("Speed", "Heat"))
            pack.with("fires/Fast/a.bag", SLOW)
            pack.with("silent/Fast/b.bag", SLOW)
            pack.with("silent/Warm/c.bag", SLOW)
            pack.with("silent/Cold/d.bag", SLOW)
            pack.with("silent/Fast/e.wpilog", "no log")
            pack.with("run.sh", "exit")
            val ended = badlog("rules", "check", pack)
            ended.code shouldBe ExitCode.SALVAGED
            ended.out.replace(Regex("\\s+"), " ").run {
                shouldContain("ok fires/Fast/a.bag: It was fast at 29.8 s.")
                shouldContain("failed silent/Fast/b.bag: It was fast at 29.8 s.")
                shouldContain("failed silent/Warm/c.bag: The rule could not run: ")
                shouldContain("failed silent/Cold/d.bag: There is no rule “Cold”; give the folder the name of a rule.")
                shouldContain("2 rules, 5 slices: 1 passes, 4 fail.")
                shouldContain("“Warm” has no slice in which it must find something; add one with badlog rules new.")
                shouldContain("“run.sh” is not part of a pack, and is ignored.")
                shouldNotContain("“Fast” has no slice")
            }
            val json = badlogJson("rules", "check", pack).json
            json.map { it.getValue("status").jsonPrimitive.content } shouldBe listOf("whole", "failed", "failed", "failed", "failed", "failed")
            json.last().getValue("failed").jsonPrimitive.int shouldBe 4
            json.last().getValue("lacking").jsonArray.map { it.jsonObject.getValue("rule").jsonPrimitive.content } shouldBe listOf("Warm")
        }
    }

    test("a pack without slices has the exit code for no result, and a wrong pack the one for usage") {
        inFolder { folder ->
            (folder / "p").with("badlog-rules.toml", RULE)
            badlog("rules", "check", folder / "p").code shouldBe ExitCode.NOTHING
            (folder / "q").with("badlog-rules.toml", "[[hook]]\ncommand='touch x'\n")
            badlog("rules", "check", folder / "q").run {
                code shouldBe ExitCode.USAGE
                err shouldContain "“hook” is not a key of a pack's rules"
            }
            badlog("rules", "check", folder / "none").code shouldBe ExitCode.USAGE
            (folder / "r").with("badlog-rules.toml", RULE.replace("Speed > 5", "Speed >"))
            (folder / "r").with("fires/Fast/a.bag", SLOW)
            badlog("rules", "check", folder / "r").run {
                code shouldBe ExitCode.USAGE
                out shouldContain "failed  fires/Fast/a.bag: The rule could not run: Line 4: Something is missing"
            }
        }
    }

    test("a slice of a built-in rule is checked like any other") {
        inFolder { folder ->
            val pack = folder / "p.badlog-rules"
            val begun = badlog("rules", "new", pack, "--from", SAMPLES / "qualification-42.bag", "--at", "1:33.7", "--name", "Browned out")
            begun.code shouldBe ExitCode.WHOLE
            begun.out shouldContain "the rule agrees: The roboRIO browned out"
            (pack / "badlog-rules.toml").readText() shouldNotContain "[[rule]]"
            badlog("rules", "check", pack).out shouldContain "0 rules, 1 slice: all slices pass."
        }
    }

    test("a slice of a WPILOG keeps its topics' own times, and its rule finds them") {
        inFolder { folder ->
            val samples = (0..600).map { it / 10.0 to (if (it in 298..302) 9.0 else 1.0) }
            val log = folder.wpilog("a.wpilog", listOf(Logged("/Speed", "double", "", samples), Logged("/Other", "double", "", listOf(0.05 to 1.0))))
            badlog("rules", "new", folder / "p", "--from", log, "--at", "30", "--name", "Fast").run {
                code shouldBe ExitCode.WHOLE
                out shouldContain "the rule agrees"
            }
            (folder / "p.badlog-rules/fires/Fast").names() shouldBe listOf("a at 30 s.wpilog")
            badlog("rules", "check", folder / "p").code shouldBe ExitCode.WHOLE
        }
    }

    test("a slice and its name do not show the owner of the log, and removals are reported") {
        inFolder { folder ->
            val header = """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"Speed"},{"name":"TeamNumber"},{"name":"Log","attrs":["log"]}],"values":[{"name":"Team","value":"1014"},{"name":"Build","value":"/home/jane/robot"},{"name":"Match Number","value":"1014"}],"secret":"jane"}"""
            val rows = (0..600).joinToString("") { "${it / 10.0},${if (it == 300) 9 else 1},1014,${if (it == 300) "jane of frc1014 at 10.10.14.2" else ""}\n" }
            val log = folder.with("1014_q42.bag", "$header\nTime,Speed,TeamNumber,Log\n$rows")
            val begun = badlog("rules", "new", folder / "p", "--from", log, "--at", "30", "--name", "Fast")
            begun.code shouldBe ExitCode.WHOLE
            begun.out.replace(Regex("\\s+"), " ") shouldContain "removed 4 team numbers, 1 address, 1 name of a user or computer, 1 path"
            val slice = (folder / "p.badlog-rules/fires/Fast").listDirectoryEntries().single()
            "${slice.fileName}" shouldBe "[team]_q42 at 30 s.bag"
            val text = slice.readText()
            for (private in listOf("jane", "10.10.14", "TeamNumber", "\"1014\"}]")) text shouldNotContain private
            text shouldContain "[user] of [team] at [address]"
            text shouldContain "{\"name\":\"Match Number\",\"value\":\"1014\"}"
            badlogJson("rules", "new", folder / "p", "--from", log, "--at", "30", "--name", "Fast").json.single().getValue("removed").jsonObject.keys shouldBe
                setOf("team", "address", "person", "path")
        }
    }

    test("a slice that cannot be cut is reported in one sentence with the next step") {
        inFolder { folder ->
            val flat = folder.with("flat.bag", SLOW.replace(",9\n", ",1\n"))
            fun new(vararg more: Any) = badlog("rules", "new", folder / "p", "--from", flat, "--name", "Fast", *more)
            new("--at", "30").run {
                code shouldBe ExitCode.NOTHING
                err shouldContain "is unusual at 30 s; say with --when"
            }
            new("--at", "100").err shouldContain "There is no 100 s in $flat; Time goes from 0 s to 60 s."
            new("--at", "30", "--silent").err shouldContain "begin without --silent"
            Files.exists(folder / "p.badlog-rules") shouldBe false
            new("--at", "30", "--when", "Speed > 5").run {
                code shouldBe ExitCode.WHOLE
                out shouldContain "the rule does not agree yet; change it in the pack: It found nothing."
            }
            new("--at", "30", "--when", "Speed > 5").err shouldContain "has a condition already"
            badlog("rules", "new", folder, "--from", flat, "--at", "30", "--name", "Fast").err shouldContain "is a folder without badlog-rules.toml"
        }
    }

    test("packs beside logs are used by report, find and export, and a page has the rules that its exporter embedded") {
        inFolder { folder ->
            folder.with("a.bag", SLOW)
            val pack = folder / "ours.badlog-rules"
            pack.with("badlog-rules.toml", RULE.replace("Speed", "our speed"))
            pack.with("badlog-signals.toml", "[[signal]]\nname='our speed'\ntopics=['Speed']\n")
            pack.with("fires/Fast/slice.bag", SLOW)
            badlog("report", folder, "--no-cache").run {
                out shouldContain "It was fast at 29.8 s."
                out shouldContain "in 1 of 1 log."
            }
            badlog("find", folder, "max(our speed)", "--no-cache").out shouldContain "Found in 1 of 1 log."
            val exported = badlogJson("export", folder / "a.bag")
            exported.json.single().getValue("rulePacks").jsonArray.map { it.jsonPrimitive.content } shouldContainExactly listOf("$pack")
            additionsIn(folder / "a.bag.html") shouldContain "It was fast at"
            badlog("report", folder / "a.bag", "--no-cache").out shouldContain "It was fast at 29.8 s."
        }
    }
})
