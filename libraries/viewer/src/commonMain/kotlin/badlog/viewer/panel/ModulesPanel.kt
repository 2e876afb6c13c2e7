package badlog.viewer.panel

import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.pen.Pen
import badlog.viewer.draw.swerve.DrivePicture
import badlog.viewer.shown.swerve.ErrorSize
import badlog.viewer.shown.swerve.ModuleError
import badlog.viewer.shown.swerve.SwerveDrive
import badlog.viewer.shown.swerve.worstModuleText
import badlog.viewer.state.PlaceAction
import badlog.viewer.text.NO_NUMBER

/**
 * Returns the modules of [drive] with their errors.
 *
 * @param errors the errors in the visible range; empty if unknown.
 * @param placeOf returns a place on x as text.
 * @param paint draws [picture] at the cursors.
 */
fun modulesPanel(
    drive: SwerveDrive,
    errors: List<ModuleError>,
    placeOf: (Double) -> String,
    picture: DrivePicture,
    paint: DrivePicture.(Pen, width: Double, PenColors) -> Unit,
): List<Part> {
    val rows = errors.flatMapIndexed { i, module ->
        listOfNotNull(module.angle, module.speed).ifEmpty { listOf(null) }.mapIndexed { place, size ->
            rowOf(module.label, cellsOf(size, placeOf), color = i, continues = place > 0)
        }
    }
    val condition = drive.errors?.condition
    return listOfNotNull(
        Paragraph("worst", if (condition == null) drive.errorsLack.orEmpty() else worstModuleText(errors)),
        Picture("picture", "Modules at the cursor", picture.height) { pen, width, colors -> picture.paint(pen, width, colors) },
        Paragraph("arrows", SwerveDrive.ARROWS, Tone.MUTED),
        if (rows.isEmpty()) null else Table("errors", COLUMNS, listOf(RowGroup(rows))),
        condition?.let { Paragraph("condition", it, Tone.MUTED) },
    )
}

private fun cellsOf(size: ErrorSize?, placeOf: (Double) -> String): List<Cell> {
    if (size == null) return listOf(Cell(NO_NUMBER), Cell(NO_NUMBER))
    val hint = "${size.largestText}: ${size.goText(placeOf(size.largestAt))}"
    return listOf(Cell(size.rmsText), Cell(size.largestText, hint, open = PlaceAction.GoTo(size.largestAt)))
}

private val COLUMNS = listOf("Module", "Error", "Largest").map { Column(it) }
