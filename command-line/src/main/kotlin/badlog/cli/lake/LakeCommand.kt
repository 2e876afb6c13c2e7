package badlog.cli.lake

import badlog.cli.command.LogCommand
import badlog.cli.command.Task
import badlog.cli.plugin.PluginLoader
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.options.required
import com.github.ajalt.clikt.parameters.types.path

internal class LakeCommand(private val parts: PluginLoader) :
    LogCommand(
        "lake",
        "Makes Parquet files of logs, for DuckDB, Spark, pandas and others.",
        "Writes a file per log, and tables of all logs (matches, topics, statistics, events, findings), to the folder --out. Run " +
            "again, it reads only logs that changed, and removes the tables of logs that are gone. docs/season.md describes the files.",
    ) {
    private val out by option(
        "-o",
        "--out",
        metavar = "FOLDER",
    ).path().required().help("Folder for the files: new, empty, or made by lake before.")

    override val examples: List<String> = listOf("lake logs --out lake/")

    override fun makeTask(): Task = LakeTask(paths, out, parts, isJson)
}
