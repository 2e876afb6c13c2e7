package badlog.cli.info

import badlog.cli.SubCommand
import badlog.cli.Task
import badlog.cli.analysis.VirtualTopicOption
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.option

/** `badlog info`. */
internal class InfoCommand :
    SubCommand(
        "info",
        "Says what is in logs.",
        "Of one log it tells the match, the x axis, values, topics and problems; of several, one line each. HZ is samples per " +
            "second. A log is held in memory while it is looked at, 8 bytes a number.",
    ) {
    private val showsTopics by option("--topics").flag().help("Show the topics, of several logs too.")
    private val showsAttributes by option("--attributes").flag().help("Show the topics with their attributes.")
    private val showsValues by option("--values").flag().help("Show the values, of several logs too.")
    private val showsProblems by option("--problems").flag().help("Show the problems, of several logs too.")
    private val xTopic by option("--x", metavar = "TOPIC").help("Take this topic as x axis, which CSV does not tell.")
    private val virtual by VirtualTopicOption()

    override fun makeTask(): Task {
        val parts = buildSet {
            if (showsTopics || showsAttributes) add(InfoPart.TOPICS)
            if (showsAttributes) add(InfoPart.ATTRIBUTES)
            if (showsValues) add(InfoPart.VALUES)
            if (showsProblems) add(InfoPart.PROBLEMS)
        }
        return InfoTask(paths, parts, xTopic, virtual.definitions, isJson)
    }
}
