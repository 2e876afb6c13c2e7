package badlog.cli.find

import badlog.cli.SubCommand
import badlog.cli.Task
import badlog.cli.analysis.VirtualTopicOption
import badlog.cli.cacheFolder
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.help
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.option

/** `badlog find`. */
internal class FindCommand :
    SubCommand(
        "find",
        "Asks a question of every log.",
        "The question is an expression, such as 'min(System/Battery Voltage) < 7'. Answers are kept in the user's cache folder, so " +
            "that a log that has not changed is not read again.",
    ) {
    private val question by argument("QUESTION").help("An expression over the topics of a log.")
    private val virtual by VirtualTopicOption()
    private val xTopic by option("--x", metavar = "TOPIC").help("Take this topic as x axis, which CSV does not tell.")
    private val isFresh by option("--no-cache").flag().help("Read every log, and keep nothing.")

    override val words: List<String> get() = super.words + question

    override fun makeTask(): Task = FindTask(paths, question, virtual.definitions, if (isFresh) null else cacheFolder(), xTopic, isJson)
}
