package badlog.page.header

import badlog.core.recording.Severity
import badlog.page.embedded.GivenLayout
import badlog.page.formula.Formulas
import badlog.protocol.PageAdditions
import badlog.viewer.panel.Trouble

/**
 * Returns all problems with [additions], [layout], and the definitions of [formulas]; the recording itself is complete. [additions] is null
 * if the additions cannot be read.
 */
internal fun additionProblems(formulas: Formulas, additions: PageAdditions?, layout: GivenLayout): List<Trouble> {
    val problems = ArrayList<Trouble>()
    fun add(message: String, pointer: String = "") {
        problems += Trouble("addition ${problems.size}", Severity.WARNING, message, pointer)
    }
    if (additions == null) {
        add("This browser cannot read the findings and calculations in this page; try another one.")
    }
    layout.problem?.let { add(it) }
    for (error in formulas.errors) {
        val kind = if (error.text in formulas.own) "Your formula" else "A formula of this page"
        add("$kind cannot be calculated: ${error.message}", error.pointed().substringAfter('\n'))
    }
    additions?.rulesProblem?.let { problem ->
        add(problem.substringBefore('\n'), problem.substringAfter('\n', ""))
    }
    additions?.notesProblem?.let { add(it) }
    for (hook in additions?.hooks.orEmpty()) {
        if (hook.error != null) add("The hook ${hook.name} failed: ${hook.error}")
    }
    return problems
}
