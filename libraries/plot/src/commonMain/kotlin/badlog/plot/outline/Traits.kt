package badlog.plot.outline

import badlog.analysis.GraphSeries
import badlog.plot.search.Trait
import badlog.recording.TopicKind

/** What a search can ask of this line, all but whether there is a finding. Looks through its samples. */
public val GraphSeries.traits: Set<Trait>
    get() = buildSet {
        when {
            isEmpty -> add(Trait.EMPTY)
            states != null -> add(Trait.STATE)
            topic.kind == TopicKind.EVENT -> add(Trait.EVENT)
            else -> add(Trait.NUMBER)
        }
        if (Trait.EMPTY !in this && topic.kind != TopicKind.EVENT && !everChanges(topic)) add(Trait.CONSTANT)
    }
