package badlog.cli.merge

/** What is called [from] in [part] is called [to] in the merge. */
internal class Renaming(val part: LogPart, val from: String, val to: String)
