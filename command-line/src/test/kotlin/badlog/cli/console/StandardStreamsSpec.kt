package badlog.cli.console

import badlog.cli.BAG
import badlog.cli.Badlog
import badlog.cli.Ended
import badlog.cli.command.ExitCode
import badlog.cli.with
import badlog.files.inFolder
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import io.kotest.matchers.string.shouldStartWith
import java.io.ByteArrayOutputStream
import java.io.PrintStream
import kotlin.io.path.div
import kotlin.io.path.readText

class StandardStreamsSpec : FunSpec({
    fun piped(input: String, vararg arguments: Any): Ended {
        val out = ByteArrayOutputStream()
        val err = ByteArrayOutputStream()
        val console = Console(PrintStream(out, true, "UTF-8"), PrintStream(err, true, "UTF-8"), false)
        val code = Badlog(console, input.byteInputStream()).run(arguments.map { it.toString() })
        return Ended(code, out.toString(Charsets.UTF_8), err.toString(Charsets.UTF_8))
    }

    test("a log from the standard input is called “standard input”") {
        val ended = piped(BAG, "info", "-")
        ended.code shouldBe ExitCode.WHOLE
        ended.out shouldStartWith "standard input\n  match   Match 42"
        piped(BAG, "info", "-", "--json").json.single().getValue("file").toString() shouldBe "\"-\""
        piped("", "info", "-", "no.bag").err shouldContain "no.bag"
    }

    test("only the result of a log from the standard input goes to the standard output") {
        val ended = piped(BAG, "cut", "-", "--from", "0.05")
        ended.code shouldBe ExitCode.WHOLE
        val (header, rows) = ended.out.split("\n", limit = 2)
        header shouldContain """{"name":"Match Number","value":"42"},{"name":"Part","value":"0.06 s to 0.08 s"}"""
        rows shouldBe "Time,Speed,Enabled,Log\n0.06,,true,stop\n0.08,5.5,false,\n"
        ended.err shouldContain "standard input -> standard output"
        piped(BAG, "convert", "-", "--to", "csv").out shouldStartWith "Time,Speed,Enabled,Log\n"
        piped(BAG, "cut", "-", "--around", "-").out shouldBe ""
    }

    test("input or output may be a file") {
        inFolder { folder ->
            piped("", "convert", folder.with("a.bag", BAG), "--to", "csv", "--out=-").out shouldStartWith "Time,Speed"
            piped(BAG, "convert", "-", "-o", folder / "b.csv").out shouldContain "standard input -> "
            (folder / "b.csv").readText() shouldStartWith "Time,Speed"
            piped(BAG, "merge", "-", folder.with("c.bag", BAG.replace("Speed", "Other")), "-o", "-").out shouldContain "Other"
        }
    }

    test("a failure leaves the standard output empty, and names no internal file") {
        val ended = piped("prose, and no log", "cut", "-", "--from", "1")
        ended.code shouldBe ExitCode.NOTHING
        ended.out shouldBe ""
        ended.err shouldNotContain "stdin"
    }
})
