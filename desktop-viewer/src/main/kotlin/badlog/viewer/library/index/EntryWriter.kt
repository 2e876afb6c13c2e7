package badlog.viewer.library.index

import java.io.DataOutputStream

/** Writes entries as [EntryReader] reads them. */
internal class EntryWriter(private val out: DataOutputStream, private val texts: TextTable) {
    /** Writes [entry]. */
    fun write(entry: LogEntry) = with(entry) {
        text(file.toString())
        out.writeLong(source.size)
        out.writeLong(source.modified)
        text(match.event)
        text(match.type)
        text(match.number)
        text(match.alliance)
        out.writeLong(date.second)
        out.writeByte(date.source.ordinal)
        out.writeDouble(duration ?: Double.NaN)
        text(xUnit)
        out.writeLong(samples)
        out.writeInt(problems.errors)
        out.writeInt(problems.warnings)
        out.writeInt(problems.notes)
        out.writeByte(content.ordinal)
        text(trouble)
        out.writeDouble(batteryMinimum ?: Double.NaN)
        text(batteryTopic)
        out.writeInt(topics.size)
        topics.forEach(::write)
    }

    private fun write(topic: TopicSummary) = with(topic.statistics) {
        text(topic.name)
        text(topic.unit)
        out.writeByte(topic.kind.ordinal)
        out.writeInt(count)
        out.writeInt(gaps)
        out.writeDouble(min)
        out.writeDouble(max)
        out.writeDouble(mean)
        out.writeDouble(standardDeviation)
        out.writeDouble(percentile5)
        out.writeDouble(median)
        out.writeDouble(percentile95)
        out.writeDouble(first)
        out.writeDouble(last)
        out.writeDouble(integral)
        out.write(topic.preview.bytes)
    }

    private fun text(text: String?) = out.writeInt(texts.placeOf(text))
}
