package badlog.cli.command

import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option

/** `--topic`, for all commands that use topics. */
internal class VirtualTopicOption : OptionGroup() {
    /** The definitions of topics to calculate, in the order of the command line. */
    val definitions: List<String> by option("--topic", metavar = "FORMULA").multiple()
        .help("Add a topic: 'Power [W] = Voltage * Current'.")
}
