package badlog.exporter.program

import badlog.exporter.BADLOG_VERSION
import badlog.exporter.EmptyPage
import badlog.exporter.PageNetwork
import badlog.files.GzipReader
import badlog.files.LogName
import badlog.files.ResultPlace
import badlog.formats.LOG_FORMATS
import badlog.formats.READABLE_LOGS
import com.github.ajalt.clikt.core.CliktError
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.MissingArgument
import com.github.ajalt.clikt.core.context
import com.github.ajalt.clikt.core.parse
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.help
import com.github.ajalt.clikt.parameters.arguments.multiple
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.options.versionOption
import com.github.ajalt.clikt.parameters.types.path
import java.io.IOException
import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.Path

internal class ArgumentParser {
    /** The result of parsing a command line: make pages, or print a text and exit. */
    sealed interface Result {
        /** A request to make pages. */
        class Run(val arguments: Arguments) : Result

        /** A request to print [text]. */
        class Say(val text: String) : Result

        /** Invalid arguments; [text] is the message for the user. */
        class Refuse(val text: String) : Result
    }

    fun parse(arguments: List<String>): Result {
        val command = Command()
        return try {
            command.parse(withAllAttachments(arguments))
            Result.Run(command.result())
        } catch (e: CliktError) {
            val text = command.getFormattedHelp(e).orEmpty().trim()
            if (e.statusCode == 0) Result.Say(text) else Result.Refuse("$text\nTry: $NAME --help")
        }
    }

    /** Returns [arguments] with an option before each file after one to attach: the original badlog took several at once. */
    private fun withAllAttachments(arguments: List<String>): List<String> {
        val all = ArrayList<String>()
        var isAttaching = false
        var isValue = false
        for ((index, argument) in arguments.withIndex()) {
            if (argument == "--") return all + arguments.drop(index)
            if (argument.startsWith("-")) {
                isValue = BEFORE_FILE.matches(argument)
                isAttaching = isValue || WITH_FILE.matches(argument)
            } else {
                isAttaching = isAttaching && (isValue || isAttachment(argument))
                if (isAttaching && !isValue) all += "-a"
                isValue = false
            }
            all += argument
        }
        return all
    }

    /** Whether [word], after a file to attach, is another one, rather than a log, a folder or the page. */
    private fun isAttachment(word: String): Boolean = try {
        val file = Path.of(word)
        val name = "${file.fileName}"
        // A log may have any name, also one without an ending.
        '.' in name.drop(1) && !LogName.of(name).mayBeLog && PAGES.none { name.endsWith(it, ignoreCase = true) } &&
            Files.isRegularFile(file) && !beginsLikeLog(file)
    } catch (_: InvalidPathException) {
        false
    }

    private fun beginsLikeLog(file: Path): Boolean {
        val head = try {
            Files.newInputStream(file).use { it.readNBytes(HEAD) }
        } catch (_: IOException) {
            return false
        }
        val isBag = head.decodeToString().removePrefix("\uFEFF").trimStart().let { it.startsWith("{") && BAG in it }
        return isBag || GzipReader.isGzip(head, head.size) || LOG_FORMATS.any { it.matches(head, head.size) }
    }

    private class Command : CoreCliktCommand(NAME) {
        private val paths by argument("INPUT").path().multiple()
            .help("A log, also gzipped, or a folder of logs: $READABLE_LOGS.")
        private val out by option("--out", metavar = "PATH").convert { ResultPlace.of(it) }
            .help("Write to this file; a name without an ending is a folder.")
        private val attachments by option("-a", "--attach", metavar = "FILE").path().multiple()
            .help("Include this file in each page; several may follow.")
        private val compared by option("--compare", metavar = "LOG").path().multiple()
            .help("Draw this log over the page's own; may be repeated.")
        private val isWithoutRules by option("--no-rules").flag()
            .help("The pages run no rules: neither those of badlog-rules.toml beside a log nor the built-in ones.")
        private val field by option("--field", metavar = "FILE").path()
            .help("WPILib's field file; default: field.json beside the log.")
        private val video by option("--video", metavar = "FILE").path()
            .help("Show this video, which is in the folder of the only page.")
        private val withEmpty by option("--empty").flag()
            .help("Also make ${EmptyPage.NAME}, a page without a log that opens others.")
        private val withServed by option("--served").flag()
            .help("Also make ${EmptyPage.SERVED_NAME}, the same page for a web server on a robot: it lists the logs of its folder.")
        private val withWeb by option("--web").flag()
            .help("Also make ${EmptyPage.WEB_NAME}, the same page for a web site: it opens logs by https that a link names.")
        private val opensPage by option("-o", "--open").flag()
            .help("Open the page in the default browser; of several, the page of the newest log.")

        init {
            // The flags of the original badlog are still accepted, although they no longer have an effect.
            registerPast("-t", "--trim-doubles", "Retry parsing doubles without whitespace; now always on.")
            registerPast("-c", "--csv", "Input is a CSV file; now detected from its content.")
            registerPast("-g", "--gzip", "Compress the embedded CSV file; now always on.")
            versionOption(BADLOG_VERSION, names = setOf("-V", "--version"), message = { "$NAME $it" })
            context { readArgumentFile = null }
        }

        private fun registerPast(short: String, long: String, text: String) = registerOption(option(short, long).flag().help(text))

        override fun help(context: Context): String = """
            Makes a web page of each log: one that opens from disk and needs nothing else.
            With one INPUT the page is INPUT.html beside it. A second argument is the page (OUTPUT)
            when it ends in .html or .htm, when it is an older page, or when it does not exist yet and is
            not named like a log (${LogName.ENDINGS.joinToString()}, .gz).
            What exists is a log by its content, never by its name.
        """.trimIndent()

        override fun helpEpilog(context: Context): String =
            "Exit code: 0 success, 3 some data was lost or left out, 1 no page was made, 2 wrong usage."

        override fun run() {
            if (paths.isEmpty() && !withEmpty && !withServed && !withWeb) throw MissingArgument(registeredArguments()[0])
        }

        fun result() = Arguments(paths, out, attachments, compared, !isWithoutRules, field, video, emptyPages(), opensPage)

        private fun emptyPages() = buildMap {
            if (withEmpty) put(EmptyPage.NAME, PageNetwork.NONE)
            if (withServed) put(EmptyPage.SERVED_NAME, PageNetwork.ROBOT)
            if (withWeb) put(EmptyPage.WEB_NAME, PageNetwork.WEB)
        }
    }

    private companion object {
        const val NAME = "badlog-html"
        val PAGES = listOf(".html", ".htm")

        /** The option for a file to attach, which may follow others of one letter. */
        val BEFORE_FILE = Regex("--attach|-[tcgo]*a")
        val WITH_FILE = Regex("--attach=.+|-[tcgo]*a.+")

        /** A key near the beginning of a bag. */
        const val BAG = "\"topics\""
        const val HEAD = 1 shl 16
    }
}
