package badlog.cli

import badlog.cli.console.Console
import badlog.cli.console.ResultStream
import badlog.cli.console.SearchCount
import badlog.files.inFolder
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.ByteArrayOutputStream
import java.io.IOException
import java.io.OutputStream
import java.io.PrintStream
import java.nio.charset.Charset
import kotlin.io.path.div

/** Clears a screen, turns the writing, and hides. */
private const val HOSTILE = "Sp\u001b[2J\u009b\u202e\u200beed"

class ConsoleSpec : FunSpec({
    test("all lines end with LF, also on Windows") {
        val bytes = ByteArrayOutputStream()
        val windows = object : PrintStream(bytes, true, Charsets.UTF_8) {
            override fun println(text: String?) = print("$text\r\n")
        }
        val console = Console(windows, windows, false)
        console.say("one\ntwo")
        console.warn("three\nfour")
        console.fail("five\nsix")
        bytes.toString(Charsets.UTF_8) shouldBe "one\ntwo\nthree\nfour\nfive\nsix\n"
    }

    fun said(text: String, charset: Charset): String {
        val out = ByteArrayOutputStream()
        Console(PrintStream(out, true, charset), System.err, false, charset).say(text)
        return out.toString(charset)
    }

    test("control characters of a log never reach the terminal") {
        inFolder { folder ->
            val log = folder.with("ev$HOSTILE.bag", BAG.replace("Speed", HOSTILE).replace("\"42\"", "\"$HOSTILE\"").replace("\u001b[2J", "[2J"))
            val rules = folder.with("r.toml", "[[rule]]\nname='R'\nseverity='note'\neach='*eed'\nwhen='topic > 5'\ntext='{topic}'")
            for (command in listOf(
                listOf("info", log), listOf("info", log, log.parent / "other.bag"), listOf("info", log, "--x", "nix"), listOf("recover", log, "--out", folder / "out/"),
                listOf("find", log, "Sped > 1", "--no-cache"), listOf("find", log, "true", "--no-cache"),
                listOf("report", log, "--rules", rules, "--no-cache"), listOf("report", log, "--rules", rules, "--no-cache", "--csv"),
                listOf("export", log, "--out", folder / "pages/"),
            )) {
                val ended = badlog(*command.toTypedArray())
                (ended.out + ended.err).filter { it != '\n' && it != '\r' && (it.isISOControl() || it in "\u202e\u200b") }.toList().shouldBeEmpty()
            }
        }
    }

    test("characters missing in an encoding are spelled out, so that different names stay different") {
        said("5× “Größe” …", Charsets.UTF_8) shouldBe "5× “Größe” …\n"
        said("5× “Größe” …", Charsets.ISO_8859_1) shouldBe "5× \"Größe\" ...\n"
        said("5× “Größe” …", Charsets.US_ASCII) shouldBe "5x \"Gr\\u00f6\\u00dfe\" ...\n"
    }

    test("a search that takes long is counted on a terminal, and leaves no trace") {
        fun shown(isTerminal: Boolean): String {
            val err = ByteArrayOutputStream()
            SearchCount(PrintStream(err), isTerminal, patience = 0).use { count -> repeat(1200) { count.next() } }
            return err.toString()
        }
        shown(isTerminal = true) shouldContain "\rlooking for logs: 1,200 files"
        shown(isTerminal = true).substringAfterLast("files").isBlank() shouldBe true
        shown(isTerminal = false) shouldBe ""
    }

    test("an ended reader is distinguished from a full disk") {
        fun after(message: String): ResultStream {
            val failing = object : OutputStream() {
                override fun write(byte: Int) = throw IOException(message)
            }
            return ResultStream(failing).also { PrintStream(it).println("a result") }
        }
        after("Broken pipe").isReaderGone shouldBe true
        after("No space left on device").run {
            isReaderGone shouldBe false
            failure?.message shouldBe "No space left on device"
        }
    }

    test("no more logs are read once the reader has ended") {
        inFolder { folder ->
            for (i in 1..9) folder.with("$i.bag", BAG)
            var writes = 0
            val closed = object : OutputStream() {
                override fun write(byte: Int) = throw IOException("Broken pipe").also { writes++ }
            }
            val console = Console(PrintStream(closed), PrintStream(OutputStream.nullOutputStream()), false)
            Badlog(console).run(listOf("info", "$folder", "--json"))
            console.isOutClosed shouldBe true
            writes shouldBe 1
        }
    }
})
