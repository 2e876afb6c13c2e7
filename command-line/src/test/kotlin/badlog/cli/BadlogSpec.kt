package badlog.cli

import badlog.cli.command.ExitCode
import badlog.cli.computer.Computer
import badlog.cli.fetch.Robots
import badlog.cli.plugin.PluginLoader
import badlog.exporter.BADLOG_VERSION
import badlog.files.inFolder
import badlog.rules.commandWords
import com.github.ajalt.clikt.core.parse
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import java.io.InputStream

@Tags("InCheck")
class BadlogSpec : FunSpec({
    val commands = listOf("info", "recover", "convert", "cut", "merge", "export", "find", "table", "report", "replay", "record", "fetch", "open", "doctor", "lake", "sql", "mcp", "rules")

    test("without arguments, as with “help”, badlog lists its commands") {
        for (asked in listOf(badlog(), badlog("--help"), badlog("help"))) {
            asked.code shouldBe ExitCode.WHOLE
            for (command in commands) asked.out shouldContain "  $command "
        }
    }

    test("each command has help that fits a terminal, by “help” and by “--help”") {
        for (command in commands) {
            val help = badlog("help", command)
            help.code shouldBe ExitCode.WHOLE
            help.out shouldBe badlog(command, "--help").out
            help.out shouldContain "Examples:\n"
            help.out shouldContain "Exit code: 0"
            help.out.lines().filter { it.length > 80 }.shouldBeEmpty()
        }
    }

    test("the help explains commands, and never calls them subcommands") {
        badlog("help", "help").out shouldContain "Explains a command."
        for (help in (listOf("help", "completion") + commands).map { badlog("help", it).out } + badlog("help").out) {
            help.lines().filter { "sub-command" in it.lowercase() || "subcommand" in it.lowercase() }.shouldBeEmpty()
        }
    }

    test("each example of the help is a command line that badlog understands, in quotes that cmd.exe knows, too") {
        for (command in commands) {
            val examples = badlog("help", command).out.lines().map { it.trim() }.filter { it.startsWith("badlog $command ") || it == "badlog $command" }
            examples.shouldNotBeEmpty()
            for (example in examples) {
                example shouldNotContain "'"
                val arguments = commandWords(example).drop(1)
                val parsed = BadlogCommand(arguments, Robots.ofSystem(), PluginLoader.ofProgram(), InputStream.nullInputStream(), Computer()).also { it.parse(arguments) }
                parsed.task.shouldNotBeNull()
            }
        }
    }

    test("the program shows its version") {
        badlog("--version").out shouldBe "badlog $BADLOG_VERSION\n"
    }

    test("a mistyped command is reported with a suggestion, whatever its arguments") {
        for (arguments in listOf(listOf("cutt"), listOf("cutt", "a", "b"), listOf("help", "cutt"), listOf("cutt", "--from", "1"))) {
            val ended = badlog(*arguments.toTypedArray())
            ended.code shouldBe ExitCode.USAGE
            ended.err shouldContain "cutt"
            ended.err shouldContain "cut”?"
            ended.err.lines().size shouldBe 2
        }
        badlog("reprot", "x").err shouldBe "There is no command “reprot”; did you mean “report” or “export”? Try: badlog help\n"
        badlog("frobnicate").err shouldBe "There is no command “frobnicate”. Try: badlog help\n"
    }

    test("wrong usage is one sentence that names the help to read") {
        val wrong = listOf(
            listOf("info"), listOf("info", "--nix", "a"), listOf("info", "a", "--nix=5"), listOf("find", "a", "-Volts < 3"), listOf("recover", "a", "--out"), listOf("convert", "a"),
            listOf("convert", "a", "--to", "pdf"), listOf("cut", "a"), listOf("cut", "a", "--from", "x"),
            listOf("cut", "a", "--from", "1", "--margin", "1"), listOf("cut", "a", "--from", "1", "--after", "1"),
            listOf("cut", "a", "--enabled", "--margin", "-1"), listOf("merge", "a", "b"),
            listOf("merge", "a", "b", "-o", "c", "--append", "--join"), listOf("fetch"), listOf("fetch", "0"), listOf("fetch", "a b"),
            listOf("fetch", "1014", "--limit", "fast"), listOf("fetch", "1014", "--delete-older-than", "2 weeks"), listOf("fetch", "1", "2"),
            listOf("lake", "a"), listOf("sql"), listOf("sql", "a", "SELECT 1", "--csv", "--json"), listOf("mcp"), listOf("mcp", "a", "b"), listOf("mcp", "a", "--json"),
            listOf("rules"), listOf("rules", "run", "a"), listOf("rules", "check"), listOf("rules", "check", "a", "--silent"), listOf("rules", "new", "a"), listOf("rules", "new", "a", "--from", "b", "--at", "x", "--name", "c"),
            listOf("info", ""), listOf("info", "a.bag", ""), listOf("export", ""), listOf("find", "", "a.bag"), listOf("assign", "", "battery", "a"),
            listOf("record"), listOf("record", "0"), listOf("record", "a b"), listOf("record", "1", "2"), listOf("record", "localhost:0"),
        )
        for (arguments in wrong) {
            val ended = badlog(*arguments.toTypedArray())
            ended.code shouldBe ExitCode.USAGE
            ended.out shouldBe ""
            ended.err shouldContain "Try: badlog help ${arguments[0]}\n"
            ended.err.lines().size shouldBe 2
        }
    }

    test("only an argument with a dash is an option, and the error says to put -- before an expression") {
        inFolder { folder ->
            badlog("info", folder.with("a=b.bag", BAG)).code shouldBe ExitCode.WHOLE
            val log = folder.with("a.bag", BAG)
            for (question in listOf("(Speed) >= 0", "((Speed)) == 1.5", "!(Speed == 1.5)")) {
                badlog("find", log, question, "--no-cache").code shouldBe ExitCode.WHOLE
            }
            badlog("find", log, "-Speed < -5").err shouldContain "put -- before it"
            badlog("find", "--no-cache", "--", log, "-Speed < -5").code shouldBe ExitCode.WHOLE
            badlog("info", log, "--topic", "A = Speed", "--topics").code shouldBe ExitCode.WHOLE
            badlog("info", log, "--atributes").err shouldContain "--attributes"
        }
    }

    test("a name that begins with @ or - can be a file") {
        inFolder { folder -> badlog("info", "--", folder.with("@a.bag", BAG)).code shouldBe ExitCode.WHOLE }
    }

    test("a shell completes sub-commands and their options by a script that badlog prints") {
        for (shell in listOf("bash", "zsh", "fish")) {
            val script = badlog("completion", shell)
            script.code shouldBe ExitCode.WHOLE
            for (word in listOf("convert", "changes-only")) script.out shouldContain word
        }
        badlog("completion", "cmd").code shouldBe ExitCode.USAGE
    }
})
