// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Gallery_AnswerPicture_h
#define Gallery_AnswerPicture_h

#include "Stage.h"

/// The last picture in grey, with what possible hits have found in yellow, and where they have
/// found nothing in dark yellow; half a picture's width beside the picture itself.
/// \param withAnswers false: the picture alone
vtkSmartPointer<vtkImageData> WithAnswers(Drawer& drawer, bool withAnswers);

#endif
