package badlog.cli.merge

/** A stretch of x, [from] until [to], in which both [one] and [other] have rows. */
internal class Overlap(val one: LogPart, val other: LogPart, val from: Double, val to: Double)
