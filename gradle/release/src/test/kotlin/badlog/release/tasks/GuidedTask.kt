package badlog.release.tasks

private val LINK = Regex("""\[([^]]+)]\(([^)]+)\)""")

/**
 * A task that CONTRIBUTING.md leads through.
 *
 * @property files the paths of the files that it names, by the texts of their links.
 */
internal class GuidedTask(val title: String, val files: Map<String, String>)

/** Returns the tasks below “Five tasks” in the text of CONTRIBUTING.md. */
internal fun guidedTasksIn(contributing: String): List<GuidedTask> {
    val sections = contributing.substringAfter("\n## Five tasks\n").substringBefore("\n## ").split("\n### ").drop(1)
    return sections.map { section ->
        val links = LINK.findAll(section).map { it.groupValues[1].trim('`') to it.groupValues[2].substringBefore('#') }
        GuidedTask(section.lineSequence().first(), links.toMap())
    }
}
