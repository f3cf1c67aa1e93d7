// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Display_h
#define Display_h

// Qt aborts where no window can be opened. Throws UserError instead.
void CheckDisplay();

#endif
